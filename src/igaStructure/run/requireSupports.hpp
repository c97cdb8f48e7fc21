// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/case/Case.hpp"

namespace tokay::structure {

/// A static analysis needs them against every rigid motion.
/// @throws InputError that names the free ones
void requireSupports(const Case& structureCase, const StructuralModel& model);

} // namespace tokay::structure
