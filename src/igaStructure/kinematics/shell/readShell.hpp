// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"

#include <string>

namespace tokay::structure {

class CaseSection;

/// Reads the description of a shell or membrane.
/// @param directory  of the case file
ShellDescription readShell(const CaseSection& file, const std::string& directory);

} // namespace tokay::structure
