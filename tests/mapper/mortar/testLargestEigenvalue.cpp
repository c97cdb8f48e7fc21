// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/largestEigenvalue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tokay::mapper {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

double ofMatrix(const MatrixXd& matrix) {
    return largestEigenvalue(matrix.rows(),
                             [&](const VectorXd& v) -> VectorXd { return matrix * v; });
}

} // namespace

TEST(LargestEigenvalue, is_that_of_a_chain_of_springs) {
    for (const int n : {2, 3, 10, 60}) {
        MatrixXd chain = 2 * MatrixXd::Identity(n, n);
        chain.diagonal(1).setConstant(-1);
        chain.diagonal(-1).setConstant(-1);
        const double exact = 2 + 2 * std::cos(M_PI / (n + 1));
        // In a long chain a close neighbour may stand for it: a per cent is what it is for.
        EXPECT_NEAR(ofMatrix(chain), exact, (n > 10 ? 1e-2 : 1e-4) * exact) << n;
    }
}

TEST(LargestEigenvalue, is_found_where_its_vector_has_no_mean) {
    MatrixXd matrix(2, 2);
    matrix << 2, -1, -1, 2;
    EXPECT_NEAR(ofMatrix(matrix), 3, 1e-12);
}

TEST(LargestEigenvalue, of_one_number_is_that_number) {
    EXPECT_EQ(ofMatrix(MatrixXd::Constant(1, 1, 5)), 5);
}

TEST(LargestEigenvalue, is_infinite_where_the_operator_is_not_finite) {
    EXPECT_EQ(ofMatrix(MatrixXd::Constant(3, 3, std::nan(""))),
              std::numeric_limits<double>::infinity());
}

} // namespace tokay::mapper
