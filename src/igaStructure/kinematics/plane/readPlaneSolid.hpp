// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/plane/PlaneSolidCase.hpp"

namespace tokay::structure {

class CaseSection;

/// Reads the structure of a case with the kinematics planeStrain or planeStress.
/// @throws InputError for entries that do not fit each other
PlaneSolidCase readPlaneSolid(const CaseSection& file);

} // namespace tokay::structure
