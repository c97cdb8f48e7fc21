// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Body.hpp"

namespace tokay::structure {

/// The fields that results shall have: those of the case, or the body's
/// default ones.
/// @throws InputError for a field that the body does not have
std::vector<std::string> chosenFields(const Body& body, const OutputOptions& options);

} // namespace tokay::structure
