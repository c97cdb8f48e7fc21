// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <string>

namespace tokay::structure {

/// A CSV file that is printed, too, line by line.
class Table {
  public:
    Table(const std::string& file, const std::string& head) : file_(file) { write(head + "\n"); }
    void write(const std::string& line) {
        fmt::print("{}", line);
        std::fflush(stdout);
        file_ << line;
    }
    /// The message of what goes wrong instead of numbers.
    void addRow(const std::string& start, const std::function<std::string()>& numbers) {
        try {
            write(start + numbers() + "\n");
        } catch (const SolverError& error) {
            write(start + fmt::format("\"{}\"\n", error.what()));
        }
    }

  private:
    std::ofstream file_;
};

} // namespace tokay::structure
