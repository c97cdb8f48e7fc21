// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <string>

namespace tokay::geometry {

/// n over k.
double binomial(int n, int k);

/// The weights, or none if they are all equal (the functions then are polynomial).
/// @throws InputError if their number is neither 0 nor n, or one is not positive.
Eigen::VectorXd checkedWeights(Eigen::VectorXd weights, int n, const std::string& owner);

/// @throws InputError if there are not n points or a coordinate is not finite.
void checkControlPoints(const Points& points, int n, const std::string& owner);

/// Rows (w x, w y, w z, w), in which refinements of rational geometry are linear.
Eigen::MatrixXd homogeneous(const Points& points, const Eigen::VectorXd& weights);

/// Points and weights of homogeneous rows; polynomial (3 columns) stays so.
std::pair<Points, Eigen::VectorXd> dehomogenised(const Eigen::MatrixXd& rows);

} // namespace tokay::geometry
