// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/ByteWriter.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace tokay::coupling {

/// Appends what a run needs to go on later to a buffer, bit by bit. Matrices
/// are preceded by their numbers of rows and columns.
class StateWriter {
  public:
    explicit StateWriter(std::vector<std::uint8_t>& bytes) : write_(bytes) {}

    void number(double value) { write_(value); }
    void integer(int value) { write_(static_cast<std::uint32_t>(value)); }
    void text(const std::string& value) { write_(value); }
    void matrix(const Eigen::MatrixXd& values) {
        integer(static_cast<int>(values.rows()));
        integer(static_cast<int>(values.cols()));
        write_(std::vector<double>(values.data(), values.data() + values.size()));
    }

  private:
    channel::ByteWriter write_;
};

} // namespace tokay::coupling
