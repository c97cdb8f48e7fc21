// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/SingularValues.hpp"
#include "common/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tokay {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rounding = 1e-14; // of matrices whose entries are about 1

// Columns k of the discrete cosine transform, orthonormal.
MatrixXd cosines(int n) {
    MatrixXd columns(n, n);
    for (int k = 0; k < n; ++k) {
        for (int i = 0; i < n; ++i) {
            columns(i, k) = std::cos(M_PI * k * (i + 0.5) / n) * std::sqrt((k == 0 ? 1. : 2.) / n);
        }
    }
    return columns;
}

// With 30 columns LAPACK divides the matrix, with 5 it does not.
class OfAProduct : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(OfAProduct, the_factors_of_a_product_are_found) {
    const auto [m, n] = GetParam();
    const int rank = std::min(m, n) - 2;
    const VectorXd values = VectorXd::LinSpaced(rank, 3, 1);
    const MatrixXd A =
        cosines(m).leftCols(rank) * values.asDiagonal() * cosines(n).leftCols(rank).transpose();
    const SingularValues found(A);
    EXPECT_LT((found.values.head(rank) - values).norm(), 10 * rounding);
    EXPECT_LT(found.values.tail(2).norm(), 10 * rounding);
    EXPECT_EQ(found.rank(1e-10), rank);
    EXPECT_EQ(found.rank(0.5), (values.array() > 1.5).count());
    // The last columns of V span what A maps to nothing, also if A has more columns than rows
    EXPECT_LT((A * found.V.rightCols(n - rank)).norm(), 10 * rounding);
    EXPECT_LT((found.V.transpose() * found.V - MatrixXd::Identity(n, n)).norm(), 30 * rounding);
    EXPECT_LT(
        (found.U * found.values.asDiagonal() * found.V.leftCols(std::min(m, n)).transpose() - A)
            .norm(),
        30 * rounding);
}

INSTANTIATE_TEST_SUITE_P(SingularValues, OfAProduct,
                         testing::Values(std::pair{7, 5}, std::pair{5, 7}, std::pair{40, 30},
                                         std::pair{30, 40}));

TEST(SingularValues, a_matrix_of_zeros_has_rank_zero) {
    EXPECT_EQ(SingularValues(MatrixXd::Zero(3, 2)).rank(1e-10), 0);
}

TEST(SingularValues, an_entry_that_is_not_finite_is_an_error) {
    MatrixXd A = MatrixXd::Identity(3, 2);
    A(2, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(SingularValues{A}, SolverError);
}

} // namespace
} // namespace tokay
