// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/largestEigenvalue.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tokay::mapper {

namespace {

/// No symmetry, so that no eigenvector is missed.
Eigen::VectorXd startVector(Eigen::Index n) {
    Eigen::VectorXd v(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        v[i] = 1 + std::sin(1.0 + 3.0 * static_cast<double>(i));
    }
    return v.normalized();
}

} // namespace

double largestEigenvalue(Eigen::Index n,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply) {
    constexpr Eigen::Index mostSteps = 100;
    constexpr double tolerance = 1e-3;
    const Eigen::Index nSteps = std::min(n, mostSteps);
    Eigen::VectorXd diagonal(nSteps), offDiagonal(nSteps);
    Eigen::VectorXd before = Eigen::VectorXd::Zero(n), here = startVector(n);
    double eigenvalue = 0;
    for (Eigen::Index k = 0; k < nSteps; ++k) {
        Eigen::VectorXd next = apply(here);
        diagonal[k] = here.dot(next);
        if (!std::isfinite(diagonal[k])) {
            return std::numeric_limits<double>::infinity();
        }
        next -= diagonal[k] * here + (k > 0 ? offDiagonal[k - 1] : 0) * before;
        offDiagonal[k] = next.norm();

        // Tridiagonal already, which SymmetricEigen would not make use of
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> projected;
        projected.computeFromTridiagonal(diagonal.head(k + 1), offDiagonal.head(k));
        eigenvalue = projected.eigenvalues()[k];
        const double residual = offDiagonal[k] * std::abs(projected.eigenvectors()(k, k));
        if (residual <= tolerance * eigenvalue || k + 1 == nSteps) {
            break;
        }
        before = std::exchange(here, next / offDiagonal[k]);
    }
    return eigenvalue;
}

} // namespace tokay::mapper
