// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"
#include "igaStructure/assembly/PatchNodes.hpp"
#include "igaStructure/assembly/SupportTrace.hpp"

#include <array>
#include <string>
#include <vector>

namespace tokay::structure {

/// Displacement components of an edge that are zero, or move.
struct Support {
    geometry::Edge edge;
    std::array<bool, 2> fixed = {false, false};
    SupportMotion motion = nullptr;
    std::string name = {};
};

/// Unknowns of a plane patch that supports fix. An open knot vector makes the
/// patch's edge depend on the edge's control points only, so fixing these is exact.
/// @return  2 nControlPoints, component c of control point k is 2 k + c
std::vector<bool> fixedUnknowns(const geometry::NurbsSurface& surface,
                                const std::vector<Support>& supports);

/// Motion of the unknowns of supports that move; what another holds at rest stays so.
SupportTrace supportTrace(const geometry::NurbsSurface& surface, const PatchNodes& nodes,
                          const std::vector<Support>& supports);

} // namespace tokay::structure
