// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"

#include <string>

namespace tokay::structure {

/// Description of the model of a case, its cost, and advice; several lines for the
/// log. Nothing is run or written.
/// @throws InputError for what would stop a run at its start
std::string checkCase(const Case& structureCase);

} // namespace tokay::structure
