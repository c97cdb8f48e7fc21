#pragma once

#include "mapper/SplineInterface.hpp"

namespace tokay::mapper {

/// The wet edges left, top, right of a flap 0.1 x 1 at the origin, biquadratic;
/// the corners at the top are shared by two pieces.
SplineInterface flapInterface();

/// Number of control points of that flap (the bottom's inner ones are dry).
int nFlapControlPoints();

/// n x 3 points on the wet edges, corners included.
Points flapPoints(int nPerEdge);

/// A quarter of a circle of radius 1, rational.
SplineInterface quarterCircle(int degree, int nSpans);

} // namespace tokay::mapper
