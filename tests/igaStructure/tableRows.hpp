// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace tokay::structure {

/// Numbers of a .dat table, its header left out.
inline std::vector<std::vector<double>> tableRows(const std::string& text) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line[0] == '#') {
            continue;
        }
        std::istringstream words(line);
        rows.emplace_back();
        for (double value; words >> value;) {
            rows.back().push_back(value);
        }
    }
    return rows;
}

} // namespace tokay::structure
