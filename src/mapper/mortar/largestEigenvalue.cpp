// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/largestEigenvalue.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

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
    constexpr double tolerance = 1e-4;
    const Eigen::Index nSteps = std::min(n, mostSteps);
    Eigen::MatrixXd basis(n, nSteps);
    Eigen::VectorXd diagonal(nSteps), offDiagonal(nSteps);
    basis.col(0) = startVector(n);
    double eigenvalue = 0;
    for (Eigen::Index k = 0; k < nSteps; ++k) {
        Eigen::VectorXd next = apply(basis.col(k));
        diagonal[k] = basis.col(k).dot(next);
        if (!std::isfinite(diagonal[k])) {
            return std::numeric_limits<double>::infinity();
        }
        const auto known = basis.leftCols(k + 1);
        for (int pass = 0; pass < 2; ++pass) {
            next -= known * (known.transpose() * next).eval();
        }
        offDiagonal[k] = next.norm();

        // Tridiagonal already, which SymmetricEigen would not make use of
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> projected;
        projected.computeFromTridiagonal(diagonal.head(k + 1), offDiagonal.head(k));
        eigenvalue = projected.eigenvalues()[k];
        const double residual = offDiagonal[k] * std::abs(projected.eigenvectors()(k, k));
        if (residual <= tolerance * eigenvalue || k + 1 == nSteps) {
            break;
        }
        basis.col(k + 1) = next / offDiagonal[k];
    }
    return eigenvalue;
}

} // namespace tokay::mapper
