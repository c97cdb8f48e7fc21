// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"
#include "geometry/trimming/TrimmedPatch.hpp"

namespace tokay::geometry {

/// Points of PatchQuadrature with its default options but for the degree.
std::vector<ParameterPoint> elementQuadrature(const TrimmedPatch& patch, int element, int degree);

/// Appends points that integrate polynomials of the total degree over a polygon.
/// The signed areas of polygons add up, as TrimmedPatch::clipped gives them: weights
/// are negative where parts overlap and cancel.
void appendCellQuadrature(const Polygon& part, int degree, std::vector<ParameterPoint>& points);

} // namespace tokay::geometry
