// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/run/StepReport.hpp"

namespace tokay::structure {

/// Runs a case without a fluid, from time 0 to its end.
/// @throws InputError, SolverError, OutputError, Interrupted
void runAlone(const Case& structureCase, const Report& report);

} // namespace tokay::structure
