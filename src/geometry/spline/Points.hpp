// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::geometry {

using Point = Eigen::Vector3d;

/// One row a point (x, y, z); a 2D scene has z = 0.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

} // namespace tokay::geometry
