// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/LocatedNode.hpp"

namespace tokay::structure {

/// Checks a map of the case file, and all in it, against the table of entries:
/// unknown, repeated and missing entries, types, ranges, lengths of lists,
/// allowed words, formulas.
/// @throws InputError for the first mistake
void validateCase(const LocatedNode& map);

/// The number at a place.
/// @throws InputError if it is none, or not finite
double readNumber(const LocatedNode& place);

/// @throws InputError if it is none
int readInteger(const LocatedNode& place);

} // namespace tokay::structure
