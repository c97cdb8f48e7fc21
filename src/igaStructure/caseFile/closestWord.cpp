// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/closestWord.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace tokay::structure {

namespace {

bool sameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}

// Levenshtein distance, one row of its table at a time.
std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replace = diagonal + (sameLetter(a[i], b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replace, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string closestWord(const std::string& given, const std::vector<std::string>& known) {
    std::string closest;
    std::size_t smallest = std::max<std::size_t>(1, given.size() / 3) + 1;
    for (const std::string& word : known) {
        const std::size_t distance = editDistance(given, word);
        if (distance < smallest) {
            smallest = distance;
            closest = word;
        }
    }
    return closest;
}

std::string suggestion(const std::string& given, const std::vector<std::string>& known) {
    const std::string word = closestWord(given, known);
    return word.empty() ? "" : "; did you mean '" + word + "'?";
}

} // namespace tokay::structure
