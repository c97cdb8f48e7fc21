// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/Material.hpp"

namespace tokay::structure {

Eigen::Matrix3d Material::stiffness() const {
    const double E = youngsModulus;
    const double nu = poissonsRatio;
    Eigen::Matrix3d C;
    if (kinematics == Kinematics::planeStress) {
        C << 1, nu, 0, nu, 1, 0, 0, 0, 0.5 * (1 - nu);
        return E / (1 - nu * nu) * C;
    }
    C << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, 0.5 - nu;
    return E / ((1 + nu) * (1 - 2 * nu)) * C;
}

double Material::thicknessStrain(const Eigen::Vector3d& strain) const {
    return kinematics == Kinematics::planeStrain
               ? 0
               : -poissonsRatio / (1 - poissonsRatio) * (strain[0] + strain[1]);
}

double Material::thicknessStress(const Eigen::Vector3d& strain) const {
    const double nu = poissonsRatio;
    return kinematics == Kinematics::planeStress
               ? 0
               : youngsModulus * nu / ((1 + nu) * (1 - 2 * nu)) * (strain[0] + strain[1]);
}

} // namespace tokay::structure
