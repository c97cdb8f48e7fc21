// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/ParameterPoint.hpp"
#include "geometry/trimming/TrimmedPatch.hpp"

namespace tokay::geometry {

/// The part of a tile inside a convex, counter-clockwise polygon, exact: tiles
/// whose sides are parts of the tile's and of the polygon's.
void appendClipped(const Tile& tile, const Polygon& convex, std::vector<Tile>& parts);

/// The part inside the loops of a convex cell that lies in one cut element: what
/// TrimmedPatch::clipped has as polygons, but with the exact curves.
std::vector<Tile> clippedTiles(const TrimmedPatch& patch, const Polygon& cell);

/// Points of positive weight that integrate polynomials of the degree in each
/// parameter as PatchQuadrature's boundaryExact rule does.
std::vector<ParameterPoint> tileQuadrature(const std::vector<Tile>& tiles, int degree);

} // namespace tokay::geometry
