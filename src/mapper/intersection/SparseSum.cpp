// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/SparseSum.hpp"

#include <cassert>

namespace tokay::mapper {

void SparseSum::add(int row, const std::vector<int>& columns, const Eigen::VectorXd& values) {
    int before = -1, here = first_[row];
    for (std::size_t j = 0; j < columns.size(); ++j) {
        assert(j == 0 || columns[j - 1] <= columns[j]);
        const double value = values[static_cast<Eigen::Index>(j)];
        if (value == 0) {
            continue;
        }
        while (here >= 0 && entries_[here].column < columns[j]) {
            before = here;
            here = entries_[here].next;
        }
        if (here < 0 || entries_[here].column > columns[j]) {
            const int added = static_cast<int>(entries_.size());
            entries_.push_back({columns[j], here, 0});
            (before < 0 ? first_[row] : entries_[before].next) = added;
            here = added;
        }
        entries_[here].value += value;
    }
}

RowSparseMatrix SparseSum::matrix() const {
    RowSparseMatrix matrix(static_cast<Eigen::Index>(first_.size()), nColumns_);
    matrix.reserve(static_cast<Eigen::Index>(entries_.size()));
    for (int row = 0; row < matrix.rows(); ++row) {
        matrix.startVec(row);
        for (int i = first_[row]; i >= 0; i = entries_[i].next) {
            matrix.insertBack(row, entries_[i].column) = entries_[i].value;
        }
    }
    matrix.finalize();
    return matrix;
}

} // namespace tokay::mapper
