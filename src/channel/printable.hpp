// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay::channel {

/// Text of a peer as it may be shown on a terminal: a question mark in place of
/// each byte of a control character (all but tab and new line), among them the
/// escape sequences by which a text could rewrite a screen, and of each byte that
/// is not UTF-8. The length stays.
std::string printable(std::string text);

} // namespace tokay::channel
