#pragma once

#include "igaStructure/caseFile/Case.hpp"
#include "igaStructure/model/PlaneSolid.hpp"

namespace tokay::structure {

/// The model that a case describes.
/// @throws InputError with the case file's name
PlaneSolid makeModel(const Case& structureCase);

/// What will be modelled, for a person: several lines.
std::string describeModel(const Case& structureCase, const PlaneSolid& solid);

} // namespace tokay::structure
