// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/solidHessian.hpp"

namespace tokay::structure {

namespace {

// Strain by the displacement gradient: sym(F^T dF), shear strains doubled.
Eigen::Matrix<double, 6, 9> strainVariation(const Eigen::Matrix3d& F) {
    Eigen::Matrix<double, 6, 9> variation = Eigen::Matrix<double, 6, 9>::Zero();
    for (int i = 0; i < 3; ++i) {
        for (int J = 0; J < 3; ++J) {
            variation(J, 3 * J + i) = F(i, J);
        }
        constexpr int pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};
        for (int k = 0; k < 3; ++k) {
            const int J = pairs[k][0];
            const int K = pairs[k][1];
            variation(3 + k, 3 * J + i) = F(i, K);
            variation(3 + k, 3 * K + i) = F(i, J);
        }
    }
    return variation;
}

} // namespace

Matrix9d solidHessian(const Eigen::Matrix3d& gradient, const ElasticResponse& response,
                      const Eigen::Matrix3d& geometricStress) {
    const Eigen::Matrix<double, 6, 9> variation = strainVariation(gradient);
    Matrix9d hessian = variation.transpose() * response.tangent * variation;
    for (int J = 0; J < 3; ++J) {
        for (int L = 0; L < 3; ++L) {
            hessian.block<3, 3>(3 * J, 3 * L).diagonal().array() += geometricStress(J, L);
        }
    }
    return hessian;
}

} // namespace tokay::structure
