#pragma once

#include "igaStructure/body/Body.hpp"
#include "igaStructure/caseFile/Case.hpp"

namespace tokay::structure {

/// What will be modelled, for a person: several lines.
std::string describeModel(const Case& structureCase, const Body& body);

} // namespace tokay::structure
