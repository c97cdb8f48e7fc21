// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/trimming/TrimmedPatch.hpp"

namespace tokay::geometry {

/// Circle in the parameter plane: an outer loop, or the rim of a hole.
TrimmingLoop circleLoop(LoopKind kind, const Parameters& centre, double radius);

/// Loop of straight lines through the corners.
TrimmingLoop polygonLoop(LoopKind kind, const Polygon& corners);

/// Square from (0, 0) to (size, size) whose parameters are positions, degree 2.
NurbsSurface square(int nSpans, double size = 1);

} // namespace tokay::geometry
