// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/case/Case.hpp"

namespace tokay::structure {

/// Refuses a model with parts that nothing connects, and a static analysis whose
/// supports leave a rigid motion free.
/// @throws InputError that names them
void requireSupports(const Case& structureCase, const StructuralModel& model);

} // namespace tokay::structure
