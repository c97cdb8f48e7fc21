// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"

#include <Eigen/Core>

namespace tokay::structure {

enum class Kinematics { planeStrain, planeStress };

/// St. Venant-Kirchhoff material of a body that deforms in its plane.
/// Strains and stresses are vectors (11, 22, 12); the third strain is doubled.
struct PlaneMaterial : ElasticMaterial {
    Kinematics kinematics = Kinematics::planeStrain;
    double thickness = 1; ///< plane strain: a slice of 1 m [m]

    /// Second Piola-Kirchhoff stress for Green-Lagrange strain [Pa].
    Eigen::Matrix3d stiffness() const;

    /// Cauchy stress at a displacement gradient [Pa].
    Eigen::Matrix3d cauchyStress(const Eigen::Matrix2d& displacementGradient,
                                 Strains strains) const;

    /// A material with the same stresses in plane stress: its Young's modulus and Poisson's
    /// ratio are E / (1 - nu^2) and nu / (1 - nu) in plane strain.
    ElasticMaterial asPlaneStress() const;

    /// Strain 33 that goes with in-plane strains.
    double thicknessStrain(const Eigen::Vector3d& strain) const;

    /// Stress 33 that goes with in-plane strains [Pa].
    double thicknessStress(const Eigen::Vector3d& strain) const;
};

} // namespace tokay::structure
