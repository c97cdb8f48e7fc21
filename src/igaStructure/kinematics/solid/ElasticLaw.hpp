// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/UnitNormal.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// Stresses and strains are vectors (11, 22, 33, 12, 23, 13); of a strain the last
/// three are doubled.
Eigen::Matrix3d symmetricOfStress(const Vector6d& stress);
Vector6d strainVector(const Eigen::Matrix3d& strain);

/// Stress, tangent and energy of a material at a Green-Lagrange strain.
struct ElasticResponse {
    Vector6d stress;   ///< second Piola-Kirchhoff [Pa]
    Matrix6d tangent;  ///< of the stress by the strain [Pa]
    double energy = 0; ///< per reference volume [J/m^3]
};

/// A material in space: St. Venant-Kirchhoff, or compressible neo-Hookean with the
/// energy mu/2 (tr C - 3) - mu ln J + lambda/2 ln^2 J.
/// Source: Bonet & Wood, Nonlinear Continuum Mechanics for Finite Element Analysis,
/// section 6.4.3
class ElasticLaw {
  public:
    /// @throws InputError for an incompressible law
    explicit ElasticLaw(const ElasticMaterial& material);

    /// Not finite where the strain leaves no volume and the law has a logarithm.
    ElasticResponse response(const Eigen::Matrix3d& strain) const;

    /// St. Venant-Kirchhoff, which all laws are at small strains.
    ElasticResponse linearResponse(const Eigen::Matrix3d& strain) const;

  private:
    ElasticResponse neoHookean(const Eigen::Matrix3d& strain) const;

    MaterialLaw law_;
    double lambda_, mu_;
    Matrix6d stiffness_;
};

} // namespace tokay::structure
