// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

#include <array>
#include <vector>

namespace tokay::structure {

/// Displacement components of an edge that are zero.
struct Support {
    geometry::Edge edge;
    std::array<bool, 2> fixed = {false, false};
};

/// Unknowns of a plane patch that supports fix. An open knot vector makes the
/// patch's edge depend on the edge's control points only, so fixing these is exact.
/// @return  2 nControlPoints, component c of control point k is 2 k + c
std::vector<bool> fixedUnknowns(const geometry::NurbsSurface& surface,
                                const std::vector<Support>& supports);

} // namespace tokay::structure
