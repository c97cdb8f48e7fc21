// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::structure {

/// Von Mises stresses of stresses in the order xx yy zz xy yz xz.
/// @param stress  6 x n [Pa]
/// @return        1 x n [Pa]
Eigen::MatrixXd vonMises(const Eigen::MatrixXd& stress);

} // namespace tokay::structure
