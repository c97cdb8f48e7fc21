// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/OutputFile.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// A .dat file with a header line and one row a time step. It appears with its
/// first row, replacing that of an earlier run, and is complete up to its last
/// row at any moment.
class ResultTable {
  public:
    /// @param columns  names with units, e.g. "time[s]"
    ResultTable(std::string path, const std::vector<std::string>& columns);

    /// @throws OutputError
    void addRow(const std::vector<double>& values);

  private:
    std::string path_;
    std::string header_;
    std::optional<OutputFile> file_;
};

} // namespace tokay::structure
