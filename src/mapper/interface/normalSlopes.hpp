// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/InterfaceCurve.hpp"

namespace tokay::mapper {

/// InterfaceCurve::normalSlopes of an edge, values by the surface's numbers.
std::vector<NormalSlope> normalSlopes(const geometry::CurveOnSurface& edge);

} // namespace tokay::mapper
