// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/rimVertices.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tokay::mapper {

std::vector<int> rimVertices(const std::vector<std::vector<int>>& faces) {
    std::map<std::pair<int, int>, int> nFaces; // next to each side; next to each end of an edge
    for (const std::vector<int>& face : faces) {
        const std::size_t n = face.size();
        for (std::size_t i = 0; i < n; ++i) {
            const int first = face[i], second = n == 2 ? first : face[(i + 1) % n];
            ++nFaces[std::minmax(first, second)];
        }
    }
    std::set<int> rim;
    for (const auto& [side, count] : nFaces) {
        if (count == 1) {
            rim.insert({side.first, side.second});
        }
    }
    return {rim.begin(), rim.end()};
}

} // namespace tokay::mapper
