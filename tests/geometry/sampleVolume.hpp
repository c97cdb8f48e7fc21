// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/primitives/primitives.hpp"
#include "geometry/primitives/volumePrimitives.hpp"
#include "geometry/spline/refinement.hpp"

#include <cmath>

namespace tokay::geometry {

/// A third of a thick cylinder (radii 1 and 2) with inner control points moved:
/// rational, several spans, no symmetry.
inline NurbsVolume sampleVolume() {
    const NurbsVolume fine =
        refine(thickened(cylinderPatch({1, 2, 3}, 1.5, 2, 0.2, 0.2 + 2 * M_PI / 3), 1), {2, 3, 2},
               {2, 2, 3});
    Points points = fine.controlPoints();
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        points.row(k) +=
            0.03 * Eigen::RowVector3d(std::sin(3.0 * k), std::cos(5.0 * k), std::sin(k));
    }
    return NurbsVolume(fine.u(), fine.v(), fine.w(), points, fine.weights());
}

} // namespace tokay::geometry
