// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"

namespace tokay::geometry {

/// Parameters at which a coordinate of the curve passes through a value,
/// ascending. Where the coordinate equals the value over a whole piece (a trim
/// line on a knot line) there is none.
/// @param axis  0, 1 or 2
std::vector<double> parameterCrossings(const NurbsCurve& curve, int axis, double value);

/// Roots in (0, 1), ascending, of a polynomial with these Bernstein coefficients.
std::vector<double> bernsteinRoots(const Eigen::VectorXd& coefficients);

} // namespace tokay::geometry
