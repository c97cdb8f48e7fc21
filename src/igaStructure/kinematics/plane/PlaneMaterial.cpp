// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneMaterial.hpp"

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

double PlaneMaterial::thicknessStrain(const Eigen::Vector3d& strain) const {
    return kinematics == Kinematics::planeStrain
               ? 0
               : -poissonsRatio / (1 - poissonsRatio) * (strain[0] + strain[1]);
}

double PlaneMaterial::thicknessStress(const Eigen::Vector3d& strain) const {
    return kinematics == Kinematics::planeStress ? 0 : lambda() * (strain[0] + strain[1]);
}

} // namespace tokay::structure
