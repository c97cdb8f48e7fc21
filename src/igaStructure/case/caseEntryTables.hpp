// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/caseFile/CaseEntry.hpp"

namespace tokay::structure {

/// The parts of caseEntries(), in its order.
const std::vector<CaseEntry>& geometryEntries();
const std::vector<CaseEntry>& modelEntries();
const std::vector<CaseEntry>& solutionEntries();
const std::vector<CaseEntry>& couplingEntries();
const std::vector<CaseEntry>& outputEntries();

/// Short names for the tables.
namespace casePresence {
constexpr auto required = Presence::required;
constexpr auto optional = Presence::optional;
constexpr auto defaulted = Presence::defaulted;
} // namespace casePresence

} // namespace tokay::structure
