// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/activeRows.hpp"

namespace tokay::mapper {

std::vector<int> rowsNotZero(const RowSparseMatrix& matrix) {
    std::vector<int> active;
    for (int row = 0; row < matrix.rows(); ++row) {
        for (RowSparseMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
            if (entry.value() != 0) {
                active.push_back(row);
                break;
            }
        }
    }
    return active;
}

Eigen::SparseMatrix<double> restricted(const RowSparseMatrix& matrix,
                                       const std::vector<int>& active) {
    std::vector<int> number(matrix.cols(), -1);
    for (std::size_t i = 0; i < active.size(); ++i) {
        number[active[i]] = static_cast<int>(i);
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const int row : active) {
        for (RowSparseMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
            if (number[entry.col()] >= 0) {
                entries.emplace_back(number[row], number[entry.col()], entry.value());
            }
        }
    }
    const Eigen::Index n = static_cast<Eigen::Index>(active.size());
    Eigen::SparseMatrix<double> reduced(n, n);
    reduced.setFromTriplets(entries.begin(), entries.end());
    return reduced;
}

} // namespace tokay::mapper
