// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/SparseSum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tokay::mapper {

TEST(SparseSum, of_blocks_at_any_place_is_that_of_a_dense_matrix) {
    constexpr int nRows = 7, nColumns = 40;
    SparseSum sum(nRows, nColumns);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nRows, nColumns);
    for (int k = 0; k < 60; ++k) {
        const int row = (5 * k) % nRows;
        std::vector<int> columns = {(11 * k) % nColumns, (17 * k + 3) % nColumns, k % nColumns};
        std::sort(columns.begin(), columns.end());
        const Eigen::Vector3d values(k + 1, -k, 0.5);
        sum.add(row, columns, values);
        for (int j = 0; j < 3; ++j) {
            dense(row, columns[j]) += values[j];
        }
    }
    // Whole and half numbers: sums are exact.
    EXPECT_EQ(Eigen::MatrixXd(sum.matrix()), dense);
}

TEST(SparseSum, has_an_entry_a_place_and_none_for_zeros) {
    SparseSum sum(2, 5);
    for (int k = 0; k < 10; ++k) {
        sum.add(1, {0, 2, 4}, Eigen::Vector3d(1, 0, 2));
    }
    const RowSparseMatrix matrix = sum.matrix();
    EXPECT_EQ(matrix.nonZeros(), 2);
    EXPECT_EQ(matrix.coeff(1, 0), 10);
    EXPECT_EQ(matrix.coeff(1, 4), 20);
}

} // namespace tokay::mapper
