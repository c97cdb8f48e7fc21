// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <fstream>
#include <string>

namespace tokay::channel {

/// The secret that a file holds for both sides: its first line, without white
/// space around it.
/// @throws InputError if the file cannot be read or the line is empty
inline std::string readToken(const std::string& fileName) {
    const char* whiteSpace = " \t\r";
    std::ifstream file(fileName);
    std::string line;
    std::getline(file, line);
    const std::size_t first = line.find_first_not_of(whiteSpace);
    if (first == std::string::npos) {
        throw InputError("the token file '" + fileName +
                         "' cannot be read or has an empty first line");
    }
    return line.substr(first, line.find_last_not_of(whiteSpace) - first + 1);
}

} // namespace tokay::channel
