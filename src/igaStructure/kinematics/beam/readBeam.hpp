// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/beam/BeamDescription.hpp"

namespace tokay::structure {

class CaseSection;

/// Reads the structure of a case with the kinematics beam or cable.
/// @throws InputError for entries that do not fit each other
BeamDescription readBeam(const CaseSection& file);

} // namespace tokay::structure
