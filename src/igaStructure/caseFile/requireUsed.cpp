// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/requireUsed.hpp"

#include "igaStructure/caseFile/CaseSection.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

void requireUsed(const CaseSection& section, const std::vector<std::string>& used,
                 const std::string& chosen) {
    for (const std::string& name : section.givenNames()) {
        if (std::find(used.begin(), used.end(), name) == used.end()) {
            throw section.error(name, fmt::format("has no meaning with {}, which takes: {}; "
                                                  "remove it",
                                                  chosen, fmt::join(used, ", ")));
        }
    }
}

} // namespace tokay::structure
