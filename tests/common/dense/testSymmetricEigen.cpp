// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/SymmetricEigen.hpp"
#include "common/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tokay {
namespace {

using Eigen::MatrixXd;

TEST(SymmetricEigen, modes_of_a_chain_of_springs_are_sines) {
    constexpr int n = 40;
    MatrixXd A = 2 * MatrixXd::Identity(n, n);
    A.diagonal(1).setConstant(-1);
    A.diagonal(-1).setConstant(-1);
    A.triangularView<Eigen::StrictlyUpper>().setConstant(7); // is not read
    const SymmetricEigen found(A);
    for (int k = 0; k < n; ++k) {
        const double half = M_PI * (k + 1) / (2 * (n + 1));
        // Rounding; in the vectors over the smallest gap between values, 0.018
        EXPECT_NEAR(found.values[k], std::pow(2 * std::sin(half), 2), 1e-13);
        const double scale = found.vectors(0, k) / std::sin(2 * half);
        for (int i = 0; i < n; ++i) {
            EXPECT_NEAR(found.vectors(i, k), scale * std::sin(2 * half * (i + 1)), 1e-11);
        }
    }
    // Rounding of some dozens of products
    EXPECT_LT((found.vectors.transpose() * found.vectors - MatrixXd::Identity(n, n)).norm(), 1e-13);
}

TEST(SymmetricEigen, an_entry_that_is_not_finite_is_an_error) {
    MatrixXd A = MatrixXd::Identity(2, 2);
    A(1, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(SymmetricEigen{A}, SolverError);
}

TEST(SymmetricEigen, an_empty_matrix_has_no_modes) {
    EXPECT_EQ(SymmetricEigen(MatrixXd(0, 0)).values.size(), 0);
}

} // namespace
} // namespace tokay
