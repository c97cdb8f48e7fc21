// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/history/LowRankMatrix.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd dense(const LowRankMatrix& matrix) {
    return matrix.A() * matrix.B().transpose();
}

TEST(LowRankMatrix, is_the_sum_of_its_terms) {
    std::srand(1);
    const MatrixXd A1 = MatrixXd::Random(7, 2);
    const MatrixXd B1 = MatrixXd::Random(5, 2);
    const MatrixXd A2 = MatrixXd::Random(7, 1);
    const MatrixXd B2 = MatrixXd::Random(5, 1);
    LowRankMatrix matrix;
    matrix.append(A1, B1);
    matrix.append(A2, B2);
    matrix.scale(3);
    const VectorXd v = VectorXd::Random(5);
    const VectorXd expected = 3 * (A1 * B1.transpose() + A2 * B2.transpose()) * v;
    EXPECT_LT((matrix.apply(v, 7) - expected).norm(), 1e-14 * 10); // rounding of some sums
    EXPECT_EQ(matrix.rank(), 3);
}

TEST(LowRankMatrix, of_rank_zero_is_the_zero_matrix) {
    LowRankMatrix matrix;
    matrix.compress(3, 0);
    EXPECT_EQ(matrix.rank(), 0);
    EXPECT_EQ(matrix.apply(VectorXd::Ones(5), 7), VectorXd::Zero(7));
}

TEST(LowRankMatrix, compression_errs_by_the_first_singular_value_left_out) {
    std::srand(2);
    LowRankMatrix matrix;
    matrix.append(MatrixXd::Random(9, 4), MatrixXd::Random(6, 4));
    const MatrixXd before = dense(matrix);
    const VectorXd values = Eigen::JacobiSVD<MatrixXd>(before).singularValues();
    matrix.compress(2, 0);
    EXPECT_EQ(matrix.rank(), 2);
    const VectorXd errors = Eigen::JacobiSVD<MatrixXd>(dense(matrix) - before).singularValues();
    EXPECT_NEAR(errors[0], values[2], 1e-13 * values[0]);
}

TEST(LowRankMatrix, compression_finds_the_true_rank) {
    // More terms than rows and columns, all of them in two directions.
    std::srand(3);
    const MatrixXd A = MatrixXd::Random(5, 2) * MatrixXd::Random(2, 20);
    const MatrixXd B = MatrixXd::Random(4, 20);
    LowRankMatrix matrix;
    matrix.append(A, B);
    matrix.compress(20, 1e-10);
    EXPECT_EQ(matrix.rank(), 2);
    EXPECT_LT((dense(matrix) - A * B.transpose()).norm(), 1e-13 * A.norm() * B.norm());
}

} // namespace
} // namespace tokay::coupling
