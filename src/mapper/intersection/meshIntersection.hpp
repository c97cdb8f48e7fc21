// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/interface/SurfaceMesh.hpp"
#include "mapper/intersection/MortarAssembler.hpp"

namespace tokay::mapper {

/// Integrates over the destination's triangles: those of the source near one, along its normal, are
/// projected onto its plane, intersected with it, and the pieces triangulated.
void integrateIntersection(const SurfaceMesh& from, const SurfaceMesh& to, const GapLimit& gapLimit,
                           MortarAssembler& assembler, GapStatistics& gaps);

} // namespace tokay::mapper
