// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/SurfaceFunctions.hpp"

#include <algorithm>

namespace tokay::structure {

void SurfaceFunctions::setProducts(const Eigen::MatrixXd& u, const Eigen::MatrixXd& v,
                                   const Eigen::VectorXd& weights) {
    constexpr int derivativesU[6] = {0, 1, 0, 2, 1, 0};
    constexpr int derivativesV[6] = {0, 0, 1, 0, 1, 2};
    const Eigen::Index nU = u.cols();
    double sums[6];
    for (int r = 0; r < 6; ++r) {
        double* row = rows_.row(r);
        for (Eigen::Index b = 0; b < v.cols(); ++b) {
            const double factor = v(derivativesV[r], b);
            for (Eigen::Index a = 0; a < nU; ++a) {
                row[a + nU * b] = u(derivativesU[r], a) * factor;
            }
        }
        if (weights.size() > 0) {
            Eigen::Map<Eigen::ArrayXd> values(row, n_);
            values *= weights.array();
            sums[r] = values.sum();
        }
    }
    if (weights.size() > 0) {
        makeRational(sums);
    }
}

// Quotient rule, Piegl & Tiller equation 4.20 for each function.
void SurfaceFunctions::makeRational(const double* W) {
    double* N = rows_.row(0);
    double* N1 = rows_.row(1);
    double* N2 = rows_.row(2);
    double* N11 = rows_.row(3);
    double* N12 = rows_.row(4);
    double* N22 = rows_.row(5);
    const double inverse = 1 / W[0];
    for (int k = 0; k < n_; ++k) {
        N[k] *= inverse;
        N1[k] = (N1[k] - N[k] * W[1]) * inverse;
        N2[k] = (N2[k] - N[k] * W[2]) * inverse;
        N11[k] = (N11[k] - 2 * N1[k] * W[1] - N[k] * W[3]) * inverse;
        N12[k] = (N12[k] - N1[k] * W[2] - N2[k] * W[1] - N[k] * W[4]) * inverse;
        N22[k] = (N22[k] - 2 * N2[k] * W[2] - N[k] * W[5]) * inverse;
    }
}

void SurfaceFunctions::set(const Eigen::MatrixXd& N) {
    for (int r = 0; r < 6; ++r) {
        for (int k = 0; k < n_; ++k) {
            rows_.row(r)[k] = N(r, k);
        }
    }
}

Eigen::Matrix<double, 3, 5> SurfaceFunctions::derivatives(const Coefficients& coefficients) const {
    Eigen::Matrix<double, 3, 5> sums = Eigen::Matrix<double, 3, 5>::Zero();
    for (int k = 0; k < n_; ++k) {
        for (int r = 0; r < 5; ++r) {
            sums.col(r) += rows_.row(r + 1)[k] * coefficients.col(k);
        }
    }
    return sums;
}

void SurfaceFunctions::addTransposed(const Eigen::Matrix<double, 3, 5>& derivatives,
                                     Coefficients& coefficients) const {
    for (int k = 0; k < n_; ++k) {
        Eigen::Vector3d sum = rows_.row(1)[k] * derivatives.col(0);
        for (int r = 1; r < 5; ++r) {
            sum += rows_.row(r + 1)[k] * derivatives.col(r);
        }
        coefficients.col(k) += sum;
    }
}

Eigen::Vector3d SurfaceFunctions::value(const Coefficients& coefficients) const {
    return coefficients * Eigen::Map<const Eigen::VectorXd>(rows_.row(0), n_);
}

} // namespace tokay::structure
