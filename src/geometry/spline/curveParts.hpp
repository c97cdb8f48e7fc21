// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// Reversed curve, over the same range of parameters.
NurbsCurve reversed(const NurbsCurve& curve);

/// Surface with xi reversed, over the same range of parameters.
NurbsSurface reversedXi(const NurbsSurface& surface);

/// The part between two parameters, exact; its ends keep their parameters.
/// @throws InputError unless first <= from < to <= last.
NurbsCurve partOf(const NurbsCurve& curve, double from, double to);

/// Ends of a curve in the parameter space of a surface.
Parameters startOf(const NurbsCurve& parameterCurve);
Parameters endOf(const NurbsCurve& parameterCurve);
/// Copy of a parameter curve with other ends.
NurbsCurve withEnds(const NurbsCurve& parameterCurve, const Parameters& start,
                    const Parameters& end);

} // namespace tokay::geometry
