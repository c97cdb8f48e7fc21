#pragma once

#include "geometry/ParameterPoint.hpp"
#include "geometry/TrimmedPatch.hpp"

namespace tokay::geometry {

/// Points of PatchQuadrature with its default options but for the degree.
std::vector<ParameterPoint> elementQuadrature(const TrimmedPatch& patch, int element, int degree);

/// Points that integrate polynomials of the total degree over polygons whose
/// signed areas add up, as TrimmedPatch::clipped gives them; weights are negative
/// where parts overlap and cancel.
std::vector<ParameterPoint> cellQuadrature(const std::vector<Polygon>& parts, int degree);

} // namespace tokay::geometry
