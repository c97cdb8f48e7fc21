// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/DenseLu.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay {
namespace {

using Eigen::MatrixXd;

// Zeros on the diagonal: no solution without exchanges of rows.
MatrixXd withZeroPivots(int n) {
    MatrixXd A(n, n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            A(i, j) = i == j ? 0 : std::cos(1.0 + 3 * i + 2.7 * i * j);
        }
    }
    return A;
}

// The blocked algorithm from some dozens of rows on.
class OfSize : public testing::TestWithParam<int> {};

TEST_P(OfSize, solutions_fulfil_the_equations_and_the_transposed_ones) {
    const int n = GetParam();
    const MatrixXd A = withZeroPivots(n);
    const MatrixXd b = MatrixXd::Identity(n, n).leftCols(3);
    const DenseLu lu(A);
    // Rounding times the condition, which is below 1e4
    EXPECT_LT((A * lu.solve(b) - b).norm(), 1e-11);
    EXPECT_LT((A.transpose() * lu.solveTransposed(b) - b).norm(), 1e-11);
}

TEST_P(OfSize, factors_multiply_to_the_rows_in_their_order) {
    const int n = GetParam();
    const MatrixXd A = withZeroPivots(n);
    const DenseLu lu(A);
    const MatrixXd L = lu.factors().triangularView<Eigen::UnitLower>();
    const MatrixXd U = lu.factors().triangularView<Eigen::Upper>();
    // Rounding of 150 products
    EXPECT_LT((L * U - A(lu.rows(), Eigen::all)).norm(), 1e-12 * A.norm());
}

INSTANTIATE_TEST_SUITE_P(DenseLu, OfSize, testing::Values(3, 8, 150));

TEST(DenseLu, of_a_singular_matrix_has_no_finite_solution) {
    MatrixXd A = MatrixXd::Identity(3, 3);
    A(2, 2) = 0;
    EXPECT_FALSE(DenseLu(A).solve(MatrixXd::Ones(3, 1)).allFinite());
}

TEST(DenseLu, of_an_empty_matrix_has_an_empty_solution) {
    EXPECT_EQ(DenseLu().solve(MatrixXd(0, 2)).size(), 0);
    EXPECT_EQ(DenseLu(MatrixXd(0, 0)).rows().size(), 0);
}

} // namespace
} // namespace tokay
