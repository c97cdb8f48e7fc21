// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// Rational cubic curve in space, with a simple and a double inner knot.
NurbsCurve sampleCurve();

/// The same with a C0 knot: a corner at xi = 0.5.
NurbsCurve curveWithCorner();

/// Rational, curved surface of degrees 2 and 3, several spans, no symmetry.
NurbsSurface sampleSurface();

/// n parameters in [0, 1], ends included, denser than any knot vector here.
std::vector<double> sampleParameters(int n);

} // namespace tokay::geometry
