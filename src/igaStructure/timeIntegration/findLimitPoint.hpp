// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/timeIntegration/MotionState.hpp"
#include "igaStructure/timeIntegration/NewtonOptions.hpp"

#include <optional>

namespace tokay::structure {

class StructuralModel;

/// Time, that is the load, at which the static equilibrium path from a state has its next
/// limit point: beyond it there is no equilibrium nearby, and no load step converges.
/// Follows the path by arcs, so it costs as much as a few tens of load steps.
/// @param from   state in equilibrium
/// @param until  time of interest [s]
/// @return       none if the path reaches that time, or cannot be followed
std::optional<double> findLimitPoint(StructuralModel& model, const NewtonOptions& newton,
                                     const MotionState& from, double until);

} // namespace tokay::structure
