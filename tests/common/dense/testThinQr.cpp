// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/ThinQr.hpp"
#include "common/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tokay {
namespace {

using Eigen::MatrixXd;

class OfShape : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(OfShape, factors_multiply_to_the_matrix) {
    const auto [m, n] = GetParam();
    MatrixXd A(m, n);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < n; ++j) {
            A(i, j) = std::sin(1.0 + 3 * i + 0.7 * i * j);
        }
    }
    const int k = std::min(m, n);
    const ThinQr qr(A);
    EXPECT_EQ(qr.Q.cols(), k);
    EXPECT_EQ(qr.R.rows(), k);
    // Rounding of some dozens of products
    EXPECT_LE((qr.Q * qr.R - A).norm(), 1e-13 * A.norm());
    EXPECT_LT((qr.Q.transpose() * qr.Q - MatrixXd::Identity(k, k)).norm(), 1e-13);
    EXPECT_TRUE(qr.R.leftCols(k).isUpperTriangular(0));
}

INSTANTIATE_TEST_SUITE_P(ThinQr, OfShape,
                         testing::Values(std::pair{7, 5}, std::pair{5, 7}, std::pair{90, 60},
                                         std::pair{4, 4}, std::pair{3, 0}));

TEST(ThinQr, an_entry_that_is_not_finite_is_an_error) {
    MatrixXd A = MatrixXd::Identity(3, 2);
    A(2, 1) = std::numeric_limits<double>::infinity();
    EXPECT_THROW(ThinQr{A}, SolverError);
}

} // namespace
} // namespace tokay
