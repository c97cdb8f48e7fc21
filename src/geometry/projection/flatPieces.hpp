// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// Bezier pieces cut so finely that each is nearly flat and evenly
/// parametrised: a point near one has one closest place on it.
std::vector<NurbsCurve> flatPieces(const NurbsCurve& curve);
std::vector<NurbsSurface> flatPieces(const NurbsSurface& surface);

} // namespace tokay::geometry
