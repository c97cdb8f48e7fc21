// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/kinematics/Body.hpp"

namespace tokay::structure {

/// Description of the model of a case, for the log: several lines.
std::string describeModel(const Case& structureCase, const Body& body);

} // namespace tokay::structure
