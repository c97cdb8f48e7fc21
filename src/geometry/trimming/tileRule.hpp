// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"
#include "geometry/trimming/Tile.hpp"

#include <vector>

namespace tokay::geometry {

/// Appends points of positive weight inside the tile. A tile with two curved
/// sides is divided by a straight line between them, cut into lower tiles where
/// none fits; a side's points run along the curve, so a horizontal tangent (a
/// root in eta) costs nothing.
/// @param nAlong   points along a side; 0 means exact for a polynomial side
/// @param degree   of the integrand in each parameter
void appendTileRule(const Tile& tile, int degree, int nAlong, std::vector<ParameterPoint>& points);

} // namespace tokay::geometry
