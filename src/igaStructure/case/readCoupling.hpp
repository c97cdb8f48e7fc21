// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Coupling.hpp"

namespace tokay::structure {

class CaseSection;

/// Reads `coupling` of the case file.
/// @throws InputError  also for an option that the chosen acceleration or the
///                     kinematics does not have
Coupling readCoupling(const CaseSection& file);

/// All options in effect, for a person: several lines.
std::string describeCoupling(const Coupling& coupling);

} // namespace tokay::structure
