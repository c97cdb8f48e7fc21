// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::structure {

/// Turns values at degree + 1 equidistant points, ends included, into
/// Bernstein coefficients.
Eigen::MatrixXd bernsteinInverse(int degree);

} // namespace tokay::structure
