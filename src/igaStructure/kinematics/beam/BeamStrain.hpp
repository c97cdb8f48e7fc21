// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// First and second derivative of a curve by its parameter; z is 0 in the plane.
struct BeamDerivatives {
    Eigen::Vector3d first;
    Eigen::Vector3d second;
};

/// Axial strain and change of curvature at a point of a beam, and how they
/// depend on the derivatives (x', x'') of its position, by the parameter.
///
/// nonlinear: axial = (|x'|^2 - |X'|^2) / (2 |X'|^2), of Green-Lagrange; curvature
/// = (x' x x'') / (|x'|^2 |X'|) - the same of the reference: the rate at which the
/// tangent turns, by the reference length. In the plane it is along z, its change
/// of angle: an end moment bends a straight beam into an exact circle, and rigid
/// motions give no strain. In space that holds of a straight reference only, for
/// the reference's curvature does not turn with the beam. linear: both linearised
/// at the reference.
class BeamStrain {
  public:
    using Matrix6d = Eigen::Matrix<double, 6, 6>;

    /// @param displacement  derivatives of the displacement
    BeamStrain(const BeamDerivatives& reference, const BeamDerivatives& displacement,
               Strains strains);

    double axial;
    Eigen::Vector3d curvature;     ///< [1/m]
    Eigen::Vector3d axialGradient; ///< by x'
    Eigen::Matrix<double, 3, 6> curvatureGradient;
    /// Second derivative of the strain, of each component by itself, before linearisation.
    double axialHessian;

    /// Second derivative of moment . curvature; zero if linear.
    Matrix6d curvatureHessian(const Eigen::Vector3d& moment) const;

  private:
    BeamDerivatives x_;
    double length_;
    bool isLinear_;
};

/// Derivative of the change of curvature by the reference length [1/m^2].
/// @param referenceThird, displacementThird  third derivatives by the parameter
Eigen::Vector3d curvatureSlope(const BeamDerivatives& reference,
                               const Eigen::Vector3d& referenceThird,
                               const BeamDerivatives& displacement,
                               const Eigen::Vector3d& displacementThird, Strains strains);

} // namespace tokay::structure
