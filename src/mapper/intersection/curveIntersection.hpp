// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/interface/CurveInterface.hpp"
#include "mapper/intersection/MortarAssembler.hpp"

namespace tokay::mapper {

/// Integrates over the destination in intervals on which both sides are smooth:
/// the source's element ends are projected onto the destination's curves, and
/// each Gauss point back onto the source.
void integrateIntersection(const CurveInterface& from, const CurveInterface& to,
                           const GapLimit& gapLimit, int nExtraPoints, MortarAssembler& assembler,
                           GapStatistics& gaps);

} // namespace tokay::mapper
