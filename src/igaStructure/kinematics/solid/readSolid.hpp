// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/solid/SolidDescription.hpp"

namespace tokay::structure {

class CaseSection;

/// Reads the structure of a case with the kinematics solid.
/// @throws InputError for entries that do not fit each other
SolidDescription readSolid(const CaseSection& file);

} // namespace tokay::structure
