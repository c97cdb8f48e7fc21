// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// A location of a patch on an edge, or any other one (its tangent then is zero).
struct PatchLocation {
    PatchLocation(const ShellPatch& patch, const geometry::Parameters& at,
                  const Eigen::Vector2d& parameterTangent);

    /// Location on a knot line, seen from an element (i, j) that it bounds.
    PatchLocation(const ShellPatch& patch, int i, int j, const geometry::Parameters& at,
                  const Eigen::Vector2d& parameterTangent);

    /// Size of the element here across the tangent [m].
    double elementSize() const { return size; }
    /// Size of the element here along the tangent [m].
    double elementLength() const;
    Eigen::Vector3d normal() const;
    /// Parameter direction across the tangent, to its right (out of the patch along a
    /// trimming curve), of unit length in space.
    Eigen::Vector2d conormal() const;

    const ShellPatch* patch;
    geometry::Parameters parameters;
    int element;
    std::vector<int> nodes;
    Eigen::MatrixXd N;                       ///< rows value, 1, 2 of the functions
    Eigen::Vector3d position;                ///< in the reference configuration
    Eigen::Matrix<double, 3, 2> baseVectors; ///< the same
    Eigen::Vector2d tangent;                 ///< baseVectors * tangent has length 1
    double size;
};

/// A quadrature point of an edge: of one patch, or of two that meet there.
struct EdgePoint {
    double weight; ///< of the reference length [m]
    PatchLocation side;
    std::optional<PatchLocation> other;
    double parameter = 0; ///< from 0 to 1 along a trimming curve
};

/// Points along a trimming curve, degree + 1 in each range that is smooth.
std::vector<EdgePoint> edgePoints(const ShellPatch& patch, const geometry::NurbsCurve& curve);

/// Points along a curve at which two patches meet, in ranges that are smooth on
/// both sides.
/// @throws InputError if the second curve is farther away than the gap [m]
std::vector<EdgePoint> edgePoints(const ShellPatch& patch, const geometry::NurbsCurve& curve,
                                  const ShellPatch& otherPatch,
                                  const geometry::NurbsCurve& otherCurve, double largestGap);

/// Points along the knot lines at which the functions of a patch have a kink, as
/// where two patches meet; each side lies to the left of its tangent. Those that are
/// trimmed away are left out.
std::vector<EdgePoint> creasePoints(const ShellPatch& patch);

/// The side of the parameter rectangle along which a trimming curve runs from end
/// to end, if it does.
std::optional<geometry::Edge> rimOf(const geometry::NurbsCurve& curve,
                                    const geometry::NurbsSurface& surface);

} // namespace tokay::structure
