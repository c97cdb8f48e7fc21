// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"

#include <vector>

namespace tokay::mapper {

/// Sum of many small dense blocks as a sparse matrix. Memory grows with the entries of the sum,
/// not with those of the blocks: a list of entries a row, in order of their columns.
class SparseSum {
  public:
    SparseSum(int nRows, int nColumns) : nColumns_(nColumns), first_(nRows, -1) {}

    /// Adds to a row; what is zero makes no entry.
    /// @param columns  ascending
    /// @param values   one a column
    void add(int row, const std::vector<int>& columns, const Eigen::VectorXd& values);

    RowSparseMatrix matrix() const;

  private:
    struct Entry {
        int column, next;
        double value;
    };

    int nColumns_;
    /// First entry of each row; -1 ends a list.
    std::vector<int> first_;
    std::vector<Entry> entries_;
};

} // namespace tokay::mapper
