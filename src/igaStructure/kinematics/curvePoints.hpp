// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "igaStructure/assembly/SupportTrace.hpp"

namespace tokay::structure {

/// Adds points along an edge that follow the motion of a support.
/// @param nodes  of the curve's control points
void addCurvePoints(const geometry::NurbsCurve& curve, const std::vector<int>& nodes,
                    const std::array<bool, 3>& components, const SupportMotion& motion,
                    std::vector<SupportPoint>& points);

/// Unknowns that supports move and none holds at rest.
std::vector<bool> movingOnly(std::vector<bool> moving, const std::vector<bool>& atRest);

} // namespace tokay::structure
