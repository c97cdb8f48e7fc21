#pragma once

#include "geometry/NurbsCurve.hpp"

namespace tokay::geometry {

/// Parameters of points on the curve such that no chord between two of them is
/// farther from it than the tolerance, measured with each axis scaled.
/// @param scales  length of each axis to which the tolerance is relative
std::vector<double> tessellation(const NurbsCurve& curve, double tolerance, const Point& scales);

} // namespace tokay::geometry
