// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tokay::structure {

class CaseSection;

/// Refuses entries that the file gives but that nothing would look at.
/// @param used   names that may be given
/// @param chosen what decides that, e.g. "scheme static"
/// @throws InputError that names the entry
void requireUsed(const CaseSection& section, const std::vector<std::string>& used,
                 const std::string& chosen);

} // namespace tokay::structure
