// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/history/LowRankMatrix.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

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

TEST(LowRankMatrix, truncated_is_what_it_was_before_further_terms) {
    std::srand(4);
    LowRankMatrix matrix;
    matrix.append(MatrixXd::Random(7, 2), MatrixXd::Random(5, 2));
    const LowRankMatrix before = matrix;
    matrix.append(MatrixXd::Random(7, 3), MatrixXd::Random(5, 3));
    matrix.truncate(2);
    EXPECT_EQ(matrix.A(), before.A());
    EXPECT_EQ(matrix.B(), before.B());
    EXPECT_EQ(matrix.columnMarks(), before.columnMarks());
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

/// Of nRows rows and columns, with these singular values and more terms of size zero.
LowRankMatrix diagonal(int nRows, const std::vector<double>& values, int nTerms) {
    LowRankMatrix matrix;
    for (int k = 0; k < nTerms; ++k) {
        const std::size_t i = static_cast<std::size_t>(k);
        const double value = i < values.size() ? values[i] : 0;
        matrix.append(value * VectorXd::Unit(nRows, k % nRows), VectorXd::Unit(nRows, k % nRows));
    }
    return matrix;
}

TEST(LowRankMatrix, compression_keeps_singular_values_above_a_fraction_of_the_largest) {
    for (const double size : {1e-6, 1.0, 1e6}) {
        LowRankMatrix matrix = diagonal(5, {size, 2e-3 * size, 0.5e-3 * size}, 3);
        matrix.compress(5, 1e-3);
        EXPECT_EQ(matrix.rank(), 2) << size;
    }
}

TEST(LowRankMatrix, rank_is_limited_to_twice_that_of_the_full_matrix) {
    const auto limited = [](int nTerms) {
        LowRankMatrix matrix = diagonal(4, {4, 3, 2, 1}, nTerms);
        matrix.limitRank({200, 1e-6});
        return matrix.rank();
    };
    EXPECT_EQ(limited(8), 8);
    EXPECT_EQ(limited(9), 4);
}

TEST(LowRankMatrix, rank_above_the_limit_is_halved_and_what_is_too_small_is_dropped) {
    const auto limited = [](const std::vector<double>& values) {
        LowRankMatrix matrix = diagonal(20, values, static_cast<int>(values.size()));
        matrix.limitRank({6, 3e-3});
        return matrix.rank();
    };
    EXPECT_EQ(limited({6, 5, 4, 3, 2, 1}), 6);
    EXPECT_EQ(limited({7, 6, 5, 4, 3, 2, 1}), 3);
    EXPECT_EQ(limited({1, 0.02, 0.004, 0.0005, 0.0004, 0.0003, 0.0002}), 3);
    EXPECT_EQ(limited({1, 0.02, 0.002, 0.0005, 0.0004, 0.0003, 0.0002}), 2);
}

TEST(LowRankMatrix, saved_factors_that_do_not_fit_are_refused) {
    std::vector<std::uint8_t> bytes;
    StateWriter written(bytes);
    written.matrix(MatrixXd::Zero(3, 2));
    written.matrix(MatrixXd::Zero(3, 1));
    StateReader state(bytes);
    LowRankMatrix matrix;
    EXPECT_THROW(matrix.restore(state, LowRankMatrix::Rows::ofInterface), channel::PeerError);
}

} // namespace
} // namespace tokay::coupling
