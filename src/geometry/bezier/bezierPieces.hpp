// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// One curve of a single span for each knot span, over the same parameters.
/// Each lies in the convex hull of its control points.
std::vector<NurbsCurve> bezierPieces(const NurbsCurve& curve);

/// One surface for each knot span (i, j), numbered i + nSpansU * j.
std::vector<NurbsSurface> bezierPieces(const NurbsSurface& surface);

} // namespace tokay::geometry
