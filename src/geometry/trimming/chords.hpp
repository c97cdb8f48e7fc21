// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/trimming/CurveOnSurface.hpp"

#include <functional>

namespace tokay::geometry {

/// Parameters, ends and breakpoints among them, such that the chords between
/// the curve's points leave it by no more than the tolerance [m].
std::vector<double> chordParameters(const NurbsCurve& curve, double tolerance);
std::vector<double> chordParameters(const CurveOnSurface& curve, double tolerance);

} // namespace tokay::geometry
