// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/SplineCoefficients.hpp"

namespace tokay::geometry {

/// The spline with an open knot vector over its range, from the knots as files
/// have them: all n + degree + 1, or without the first and the last, which mean
/// nothing; open or not (periodic curves of CAD programs are not).
/// @param rows  n x m coefficients
/// @throws InputError if the number of knots fits neither way, they descend, or
/// the range is empty.
SplineCoefficients openSpline(int degree, std::vector<double> knots, Eigen::MatrixXd rows);

} // namespace tokay::geometry
