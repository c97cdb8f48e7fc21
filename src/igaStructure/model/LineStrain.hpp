#pragma once

#include "igaStructure/model/Strains.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// First and second derivative of a plane curve by its parameter.
struct LineDerivatives {
    Eigen::Vector2d first;
    Eigen::Vector2d second;
};

/// Axial strain and change of curvature at a point of a line, and how they
/// depend on the derivatives (x', x'') of its position, by the parameter.
///
/// nonlinear: axial = (|x'|^2 - |X'|^2) / (2 |X'|^2), of Green-Lagrange;
/// curvature = d(angle of the tangent)/ds - the same of the reference, s being the
/// reference length: an end moment bends a straight beam into an exact circle,
/// and rigid motions give no strain. linear: both linearised at the reference.
struct LineStrain {
    double axial;
    double curvature; ///< [1/m]
    Eigen::Vector4d axialGradient;
    Eigen::Vector4d curvatureGradient;
    Eigen::Matrix4d axialHessian;     ///< linear: of the strain before linearisation
    Eigen::Matrix4d curvatureHessian; ///< zero if linear

    /// @param displacement  derivatives of the displacement
    LineStrain(const LineDerivatives& reference, const LineDerivatives& displacement,
               Strains strains);
};

/// Derivative of the change of curvature by the reference length [1/m^2].
/// @param referenceThird, displacementThird  third derivatives by the parameter
double curvatureSlope(const LineDerivatives& reference, const Eigen::Vector2d& referenceThird,
                      const LineDerivatives& displacement, const Eigen::Vector2d& displacementThird,
                      Strains strains);

/// z component of a x b.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// Turned by a quarter counter-clockwise.
inline Eigen::Vector2d turned(const Eigen::Vector2d& a) {
    return {-a[1], a[0]};
}

} // namespace tokay::structure
