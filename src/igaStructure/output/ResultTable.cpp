// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/output/ResultTable.hpp"

#include <fmt/format.h>

namespace tokay::structure {

ResultTable::ResultTable(std::string path, const std::vector<std::string>& columns)
    : path_(std::move(path)), header_(fmt::format("# {}\n", fmt::join(columns, " "))) {}

void ResultTable::addRow(const std::vector<double>& values) {
    const bool isFirst = !file_;
    if (isFirst) {
        file_.emplace(path_);
        file_->write(header_);
    }
    file_->write(fmt::format("{:.12g}\n", fmt::join(values, " ")));
    if (isFirst) {
        file_->publish();
    } else {
        file_->flush();
    }
}

} // namespace tokay::structure
