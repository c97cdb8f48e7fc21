// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::structure {

enum class Kinematics { planeStrain, planeStress };

/// St. Venant-Kirchhoff material of a body that deforms in its plane.
/// Strains and stresses are vectors (11, 22, 12); the third strain is doubled.
struct Material {
    Kinematics kinematics = Kinematics::planeStrain;
    double youngsModulus = 0; ///< [Pa]
    double poissonsRatio = 0;
    double density = 0;          ///< reference configuration [kg/m^3]
    double thickness = 1;        ///< plane strain: a slice of 1 m [m]
    double massDamping = 0;      ///< Rayleigh [1/s]
    double stiffnessDamping = 0; ///< Rayleigh [s]

    /// Second Piola-Kirchhoff stress for Green-Lagrange strain [Pa].
    Eigen::Matrix3d stiffness() const;

    /// Strain 33 that goes with in-plane strains.
    double thicknessStrain(const Eigen::Vector3d& strain) const;

    /// Stress 33 that goes with in-plane strains [Pa].
    double thicknessStress(const Eigen::Vector3d& strain) const;
};

} // namespace tokay::structure
