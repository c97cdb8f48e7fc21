// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::structure {

/// z component of a x b.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// Turned by a quarter counter-clockwise.
inline Eigen::Vector2d turned(const Eigen::Vector2d& a) {
    return {-a[1], a[0]};
}

} // namespace tokay::structure
