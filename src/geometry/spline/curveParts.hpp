// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"

namespace tokay::geometry {

/// Reversed curve, over the same range of parameters.
NurbsCurve reversed(const NurbsCurve& curve);

/// The part between two parameters, exact; its ends keep their parameters.
/// @throws InputError unless first <= from < to <= last.
NurbsCurve partOf(const NurbsCurve& curve, double from, double to);

} // namespace tokay::geometry
