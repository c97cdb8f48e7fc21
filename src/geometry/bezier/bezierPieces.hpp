// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// Bezier pieces of a curve, one per knot span, over the same parameters.
/// Each lies in the convex hull of its control points.
std::vector<NurbsCurve> bezierPieces(const NurbsCurve& curve);

/// Bezier pieces of a surface; that of knot span (i, j) has index i + nSpansU * j.
std::vector<NurbsSurface> bezierPieces(const NurbsSurface& surface);

} // namespace tokay::geometry
