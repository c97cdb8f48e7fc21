// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/InterfaceCurve.hpp"

namespace tokay::mapper {

/// The functions' derivatives along a direction, by its part in the tangent plane [1/m].
Functions directionalDerivative(const geometry::NurbsSurface& surface, double xi, double eta,
                                const Point& direction);

/// The whole elements that an edge cuts or, along a knot line, touches on its left.
std::vector<geometry::ParameterBox> cutElements(const geometry::CurveOnSurface& edge);

/// InterfaceCurve::normalSlopes of an edge, values by the surface's numbers.
std::vector<NormalSlope> normalSlopes(const geometry::CurveOnSurface& edge);

} // namespace tokay::mapper
