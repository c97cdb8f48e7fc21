#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/assembly/StructuralModel.hpp"

namespace tokay::structure {

/// A static analysis needs them against every rigid motion.
/// @throws InputError that names the free ones
void requireSupports(const Case& structureCase, const StructuralModel& model);

} // namespace tokay::structure
