// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay::channel {

/// The secret that a file holds for both sides: its first line, without white
/// space around it.
/// @throws InputError if the file cannot be read, is open to other users, or the
///         line is empty
std::string readToken(const std::string& fileName);

} // namespace tokay::channel
