// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tokay::structure {

/// The word of `known` that the user most likely meant by `given`: the one at
/// the smallest edit distance, letter case ignored; empty if none is close
/// (more than a third of the letters differ).
std::string closestWord(const std::string& given, const std::vector<std::string>& known);

/// "; did you mean X?" or an empty text, to end a message with.
std::string suggestion(const std::string& given, const std::vector<std::string>& known);

} // namespace tokay::structure
