// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SplineInterface.hpp"

namespace tokay::mapper {

/// The wet edges left, top, right of a flap 0.1 x 1 at the origin, biquadratic;
/// the corners at the top are shared by two pieces.
SplineInterface flapInterface();

/// Number of control points of that flap (the bottom's inner ones are dry).
int nFlapControlPoints();

/// n x 3 points on the wet edges, corners included.
Points flapPoints(int nPerEdge);

/// n line elements from (x, 0, 0) to (x, 1, 0), spaced unevenly.
CurveInterface verticalMesh(int nElements, double x = 0);

/// The same elements with a value on each.
CurveInterface verticalFaces(int nElements, double x = 0);

/// The line from (x, 0, 0) to (x, 1, 0) as a spline.
SplineInterface verticalSpline(int degree, int nSpans, double x = 0);

/// The line x = 0, 0 < y < 1 as an edge of a biquadratic patch that reaches
/// beyond it, 2 x 2 elements; the edge lies at the parameter xi.
CurveInterface trimmedEdge(double xi);

/// A quarter of a circle of radius 1, rational.
SplineInterface quarterCircle(int degree, int nSpans);

} // namespace tokay::mapper
