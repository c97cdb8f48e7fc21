// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/isStraight.hpp"

#include <Eigen/Geometry>

namespace tokay::structure {

bool isStraight(const geometry::NurbsCurve& curve) {
    constexpr double rounding = 1e-10;
    const geometry::Points& points = curve.controlPoints();
    const geometry::Point start = points.row(0);
    const geometry::Point chord = points.row(points.rows() - 1).transpose() - start;
    for (const auto& point : points.rowwise()) {
        const geometry::Point from = point.transpose() - start;
        if (chord.cross(from).norm() > rounding * chord.squaredNorm()) {
            return false;
        }
    }
    return true;
}

} // namespace tokay::structure
