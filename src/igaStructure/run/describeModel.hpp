#pragma once

#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/case/Case.hpp"

namespace tokay::structure {

/// What will be modelled, for a person: several lines.
std::string describeModel(const Case& structureCase, const Body& body);

} // namespace tokay::structure
