// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/GrowingLu.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tokay::coupling {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Conditions below 1e3.
constexpr double rounding = 1e-12;

void appendTo(GrowingLu& factors, const MatrixXd& A, Index n) {
    const Index before = factors.size();
    const Index k = n - before;
    factors.append(A.block(0, before, before, k), A.block(before, 0, k, before),
                   A.block(before, before, k, k));
}

double errorOf(const GrowingLu& factors, const MatrixXd& A) {
    const VectorXd x = VectorXd::Random(A.rows());
    return (factors.solve(A * x) - x).norm() / x.norm();
}

TEST(GrowingLu, solves_after_each_growth_by_one_or_several) {
    std::srand(5);
    const MatrixXd A = 5 * MatrixXd::Identity(12, 12) + MatrixXd::Random(12, 12);
    GrowingLu factors;
    for (const Index n : {4, 5, 6, 9, 12}) {
        appendTo(factors, A, n);
        EXPECT_EQ(factors.size(), n);
        EXPECT_LT(errorOf(factors, A.topLeftCorner(n, n)), rounding) << n;
    }
}

TEST(GrowingLu, exchanges_rows_that_are_appended_together) {
    std::srand(6);
    MatrixXd A = MatrixXd::Random(7, 7);
    A.topLeftCorner(4, 4) = MatrixXd::Identity(4, 4).rowwise().reverse(); // zeros on the diagonal
    GrowingLu factors;
    appendTo(factors, A, 4);
    appendTo(factors, A, 7);
    EXPECT_LT(errorOf(factors, A), rounding);
}

TEST(GrowingLu, begins_anew_when_cleared) {
    GrowingLu factors;
    appendTo(factors, MatrixXd::Constant(1, 1, 3), 1);
    factors.clear();
    const MatrixXd A = MatrixXd::Identity(2, 2) * 4;
    appendTo(factors, A, 2);
    EXPECT_LT(errorOf(factors, A), rounding);
}

TEST(GrowingLu, a_singular_matrix_has_no_finite_solution) {
    GrowingLu factors;
    appendTo(factors, MatrixXd::Zero(2, 2), 2);
    EXPECT_FALSE(factors.solve(VectorXd::Ones(2)).allFinite());
}

} // namespace
} // namespace tokay::coupling
