// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "igaStructure/kinematics/beam/BeamStrain.hpp"

#include <vector>

namespace tokay::structure {

/// A quadrature point of a beam, with the functions there.
struct BeamPoint {
    int dimension; ///< components a control point of fields: 2, in the plane, or 3
    int element;
    int first;                ///< control point of the first function
    Eigen::MatrixXd N;        ///< rows: functions, first and second derivatives by xi
    BeamDerivatives position; ///< derivatives in the reference configuration
    geometry::Point at;
    double length; ///< quadrature weight times line element [m]

    /// Derivatives of a field.
    BeamDerivatives derivatives(const Eigen::VectorXd& field) const;
};

/// Gauss points of all elements of a curve, element after element.
/// @throws GeometryError if the curve has no tangent at one of them, or turns back
std::vector<BeamPoint> beamPoints(const geometry::NurbsCurve& curve, int nPointsPerElement,
                                  int dimension);

} // namespace tokay::structure
