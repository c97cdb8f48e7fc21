// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/quadrature/Triangle.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/intersection/parameterPolygon.hpp"

namespace tokay::mapper {

/// The triangle by its corners' projections; if the pole of a patch lies inside
/// it or on a side, the parts of it that have the pole as a corner. The pole is
/// inside where the patch's normal there pierces the triangle: so of neighbours
/// one has it, or both have it on their common side.
std::vector<std::array<ProjectedCorner, 3>>
partsAroundPole(const SurfaceInterface& splines, int piece, const geometry::Triangle& triangle,
                const std::array<ProjectedCorner, 3>& corners);

} // namespace tokay::mapper
