// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/kinematics/Body.hpp"

#include <string>

namespace tokay::structure {

/// Advice on a case's choice of model and numbers, each with the estimate behind
/// it, for the log: lines that begin with "advice: ". It needs a
/// factorisation and the three lowest natural modes.
std::string advise(const Case& structureCase, Body& body);

} // namespace tokay::structure
