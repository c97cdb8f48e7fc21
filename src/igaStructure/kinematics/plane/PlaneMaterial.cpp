// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneMaterial.hpp"

#include <Eigen/LU>

#include <cmath>

namespace tokay::structure {

Eigen::Matrix3d PlaneMaterial::stiffness() const {
    const double nu = poissonsRatio;
    Eigen::Matrix3d C;
    if (kinematics == Kinematics::planeStress) {
        C << 1, nu, 0, nu, 1, 0, 0, 0, 0.5 * (1 - nu);
        return planeStressModulus() * C;
    }
    C << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, 0.5 - nu;
    return youngsModulus / ((1 + nu) * (1 - 2 * nu)) * C;
}

Eigen::Matrix3d PlaneMaterial::cauchyStress(const Eigen::Matrix2d& H, Strains strains) const {
    Eigen::Matrix2d E = 0.5 * (H + H.transpose());
    if (strains == Strains::nonlinear) {
        E += 0.5 * H.transpose() * H;
    }
    const Eigen::Vector3d strain(E(0, 0), E(1, 1), 2 * E(0, 1));
    const Eigen::Vector3d inPlane = stiffness() * strain;
    Eigen::Matrix3d stress; // second Piola-Kirchhoff
    stress << inPlane[0], inPlane[2], 0, inPlane[2], inPlane[1], 0, 0, 0, thicknessStress(strain);
    if (strains == Strains::linear) {
        return stress;
    }
    Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
    F.topLeftCorner<2, 2>() = Eigen::Matrix2d::Identity() + H;
    F(2, 2) = std::sqrt(1 + 2 * thicknessStrain(strain));
    return F * stress * F.transpose() / F.determinant();
}

ElasticMaterial PlaneMaterial::asPlaneStress() const {
    ElasticMaterial same = *this;
    if (kinematics == Kinematics::planeStrain) {
        same.youngsModulus = planeStressModulus();
        same.poissonsRatio = poissonsRatio / (1 - poissonsRatio);
    }
    return same;
}

double PlaneMaterial::thicknessStrain(const Eigen::Vector3d& strain) const {
    return kinematics == Kinematics::planeStrain
               ? 0
               : -poissonsRatio / (1 - poissonsRatio) * (strain[0] + strain[1]);
}

double PlaneMaterial::thicknessStress(const Eigen::Vector3d& strain) const {
    return kinematics == Kinematics::planeStress ? 0 : lambda() * (strain[0] + strain[1]);
}

} // namespace tokay::structure
