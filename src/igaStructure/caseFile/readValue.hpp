// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/LocatedNode.hpp"
#include "common/Schema.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// Reads a value that is not a map, nor a list of maps, into options.
/// @throws InputError if it is of another kind or length, or out of range
void readValue(const LocatedNode& place, const Entry& entry, const Slot& slot);

/// Index of the word at a place among alternatives.
/// @throws InputError that suggests the closest one
std::size_t readChoice(const LocatedNode& place, const std::vector<Alternative>& alternatives);

/// @throws InputError if the node is not a list
void requireList(const LocatedNode& list);

/// "must be a number, but is 'stiff'"
InputError wrongKind(const LocatedNode& place, const std::string& wanted);

/// Names, for a message.
std::string listed(const std::vector<std::string>& names);

} // namespace tokay::structure
