// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/readValues.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

namespace tokay::tool {

namespace {

std::vector<double> numbersOf(std::string line, const std::string& place) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        char* end = nullptr;
        numbers.push_back(std::strtod(word.c_str(), &end));
        if (*end != '\0') {
            throw InputError(fmt::format("{}: '{}' is not a number", place, word));
        }
    }
    return numbers;
}

} // namespace

Eigen::MatrixXd readValues(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw InputError(fmt::format("{}: the file cannot be opened", path));
    }
    std::vector<double> all;
    std::size_t nColumns = 0;
    int lineNumber = 0;
    for (std::string line; std::getline(file, line);) {
        ++lineNumber;
        const std::string place = fmt::format("{}:{}", path, lineNumber);
        if (line.empty() || line[0] == '#') {
            continue;
        }
        const std::vector<double> row = numbersOf(line, place);
        if (nColumns == 0) {
            nColumns = row.size();
        }
        if (row.size() != nColumns) {
            throw InputError(fmt::format("{}: {} numbers, but the lines before have {}", place,
                                         row.size(), nColumns));
        }
        all.insert(all.end(), row.begin(), row.end());
    }
    if (all.empty()) {
        throw InputError(fmt::format("{}: there is no number in it", path));
    }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto columns = static_cast<Eigen::Index>(nColumns);
    return Eigen::Map<const Rows>(all.data(), static_cast<Eigen::Index>(all.size()) / columns,
                                  columns);
}

} // namespace tokay::tool
