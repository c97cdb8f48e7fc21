// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace tokay {

/// A mistake in what the user gave: the message says what is wrong, its
/// value, where it stands (file, line, key) and what to change.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A computation that could not be completed: singular matrix, diverged
/// iteration, value that is not finite.
class SolverError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Text of the user's as a message quotes it: its start if it is long.
inline std::string shortened(const std::string& text) {
    constexpr std::size_t maxLength = 80;
    return text.size() <= maxLength ? text : text.substr(0, maxLength) + "...";
}

} // namespace tokay
