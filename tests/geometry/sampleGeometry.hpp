// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/trimming/TrimmedPatch.hpp"

namespace tokay::geometry {

/// Rational cubic curve in space, with a simple and a double inner knot.
NurbsCurve sampleCurve();

/// The same with a C0 knot: a corner at xi = 0.5.
NurbsCurve curveWithCorner();

/// Rational, curved surface of degrees 2 and 3, several spans, no symmetry.
NurbsSurface sampleSurface();

/// y = x^2 from x = -1 to 2, which is -1 + 3 xi. From its vertex's centre of curvature
/// (0, 0.5) the distance grows with x^4 only, slower than Newton's method can follow.
NurbsCurve parabola();

/// The parabola drawn along z from 0 to 1, which is eta.
NurbsSurface parabolicCylinder();

/// What lies below the parabola of the plate [-1, 2] x [-1, 4].
TrimmedPatch plateBelowParabola();

/// n parameters in [0, 1], ends included, denser than any knot vector here.
std::vector<double> sampleParameters(int n);

} // namespace tokay::geometry
