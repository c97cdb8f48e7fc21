// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"

#include <string>

namespace tokay::structure {

/// What a case would model and need, and what looks doubtful in it; several
/// lines for a person. Nothing is run or written.
/// @throws InputError for what would stop a run at its start
std::string checkCase(const Case& structureCase);

} // namespace tokay::structure
