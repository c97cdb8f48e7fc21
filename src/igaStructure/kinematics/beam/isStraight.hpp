// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"

namespace tokay::structure {

/// True if all control points lie on the line through the first and last one,
/// to rounding.
bool isStraight(const geometry::NurbsCurve& curve);

} // namespace tokay::structure
