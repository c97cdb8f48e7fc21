// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/run/StepReport.hpp"

namespace tokay::structure {

/// Computes the lowest natural modes of a case at rest: a line each for the log,
/// the table postProcessing/<name>/modes.dat, and the mode shapes for ParaView
/// (<name>Modes.pvd; the mode's number as time, the largest displacement of a
/// control point a tenth of the structure's size).
/// @throws InputError, SolverError, OutputError
void runModes(const Case& structureCase, int count, const Report& report);

} // namespace tokay::structure
