// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"

namespace tokay::structure {

class CaseSection;

/// @throws InputError for the first mistake: file, line, entry, what to change
Case readCase(const std::string& fileName);

/// As above, from a validated file.
Case readCase(const CaseSection& file, const std::string& fileName);

} // namespace tokay::structure
