// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/caseEntryTables.hpp"

namespace tokay::structure {

namespace {

std::vector<CaseEntry> joined() {
    std::vector<CaseEntry> entries;
    for (const auto& part : {geometryEntries(), modelEntries(), solutionEntries(),
                             couplingEntries(), outputEntries()}) {
        entries.insert(entries.end(), part.begin(), part.end());
    }
    return entries;
}

} // namespace

const std::vector<CaseEntry>& caseEntries() {
    static const std::vector<CaseEntry> entries = joined();
    return entries;
}

} // namespace tokay::structure
