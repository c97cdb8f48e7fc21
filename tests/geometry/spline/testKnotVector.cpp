// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/KnotVector.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

namespace {
const KnotVector knots(3, {0, 0, 0, 0, 0.2, 0.5, 0.5, 0.9, 1, 1, 1, 1});
}

TEST(KnotVector, functions_sum_to_one_and_their_derivatives_to_zero) {
    for (const double xi : sampleParameters(41)) {
        const Eigen::MatrixXd N = knots.basisDerivatives(knots.findSpan(xi), xi, 3);
        EXPECT_NEAR(N.row(0).sum(), 1, 1e-14);
        EXPECT_GE(N.row(0).minCoeff(), 0);
        // Derivatives are of size (degree / span)^k, here up to 3e4 for k = 3.
        for (int k = 1; k <= 3; ++k) {
            EXPECT_NEAR(N.row(k).sum(), 0, 1e-14 * N.row(k).cwiseAbs().sum() + 1e-14);
        }
    }
}

TEST(KnotVector, functions_reproduce_the_parameter_from_the_greville_abscissae) {
    const std::vector<double> greville = knots.grevilleAbscissae();
    ASSERT_EQ(static_cast<int>(greville.size()), knots.nBasis());
    for (const double xi : sampleParameters(41)) {
        const int span = knots.findSpan(xi);
        const Eigen::MatrixXd N = knots.basisDerivatives(span, xi, 1);
        double value = 0, slope = 0;
        for (int j = 0; j <= 3; ++j) {
            value += N(0, j) * greville[span - 3 + j];
            slope += N(1, j) * greville[span - 3 + j];
        }
        EXPECT_NEAR(value, xi, 1e-14);
        EXPECT_NEAR(slope, 1, 1e-12);
    }
}

TEST(KnotVector, derivatives_agree_with_finite_differences) {
    // Central differences: error h^2 f''' / 6 plus rounding 1e-16 / h; for
    // h = 1e-5 and derivatives up to 3e4 that is 1e-6 of the derivative's scale.
    const double h = 1e-5;
    for (const double xi : {0.1, 0.33, 0.7, 0.95}) {
        const int span = knots.findSpan(xi);
        const Eigen::MatrixXd N = knots.basisDerivatives(span, xi, 3);
        const Eigen::MatrixXd ahead = knots.basisDerivatives(span, xi + h, 3);
        const Eigen::MatrixXd behind = knots.basisDerivatives(span, xi - h, 3);
        for (int k = 0; k < 3; ++k) {
            const Eigen::RowVectorXd difference = (ahead.row(k) - behind.row(k)) / (2 * h);
            EXPECT_LT((difference - N.row(k + 1)).norm(), 1e-6 * N.row(k + 1).norm());
        }
    }
}

TEST(KnotVector, values_and_slopes_are_those_of_basis_derivatives) {
    for (const KnotVector& other : {knots, KnotVector::uniform(1, 3), KnotVector::uniform(5, 4)}) {
        Eigen::Matrix2Xd N(2, other.degree() + 1);
        for (const double xi : sampleParameters(41)) {
            const int span = other.findSpan(xi);
            other.valuesAndSlopes(span, xi, N);
            EXPECT_LT((N - other.basisDerivatives(span, xi, 1)).norm(), 1e-13 * N.norm());
        }
    }
}

TEST(KnotVector, derivatives_above_the_degree_vanish) {
    const Eigen::MatrixXd N = knots.basisDerivatives(knots.findSpan(0.3), 0.3, 5);
    EXPECT_EQ(N.bottomRows(2).norm(), 0);
    EXPECT_GT(N.row(3).norm(), 0);
}

TEST(KnotVector, find_span_skips_empty_spans_and_closes_the_last) {
    EXPECT_EQ(knots.findSpan(0), 3);
    EXPECT_EQ(knots.findSpan(0.5), 6);
    EXPECT_EQ(knots.findSpan(0.4999), 4);
    EXPECT_EQ(knots.findSpan(1), 7);
    EXPECT_EQ(knots.findSpan(-1), 3);
    EXPECT_EQ(knots.findSpan(2), 7);
}

TEST(KnotVector, uniform_has_equal_spans) {
    const KnotVector uniform = KnotVector::uniform(2, 4, -1, 1);
    EXPECT_EQ(uniform.nBasis(), 6);
    EXPECT_EQ(uniform.breakpoints(), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
}

TEST(KnotVector, refuses_what_is_not_an_open_knot_vector_and_says_why) {
    expectInputError([] { KnotVector(0, {0, 1}); }, {"degree", "0"});
    expectInputError([] { KnotVector(2, {0, 0, 0, 1, 1}); }, {"6", "5"});
    expectInputError([] { KnotVector(1, {0, 0, 0.6, 0.5, 1, 1}); }, {"knot 3", "0.5", "0.6"});
    expectInputError([] { KnotVector(2, {0, 0, 0.5, 0.5, 1, 1, 1}); }, {"end knot 0", "2", "3"});
    expectInputError([] { KnotVector(1, {0, 0, 0.5, 0.5, 1, 1}); }, {"inner knot 0.5", "2"});
    expectInputError([] { KnotVector(1, {0, 0, NAN, 1, 1}); }, {"knot 2", "finite"});
}

TEST(KnotVector, refuses_a_degree_beyond_the_limit) {
    EXPECT_EQ(KnotVector::uniform(KnotVector::maxDegree, 2).nBasis(), KnotVector::maxDegree + 2);
    expectInputError([] { KnotVector::uniform(KnotVector::maxDegree + 1, 2); }, {"25", "24"});
}

TEST(KnotVector, range_without_a_finite_inverse_is_refused) {
    EXPECT_THROW(KnotVector(1, {0, 0, 1e-320, 1e-320}), InputError);
    EXPECT_THROW(KnotVector(1, {-1e308, -1e308, 1e308, 1e308}), InputError);
    EXPECT_NO_THROW(KnotVector(1, {0, 0, 1e-40, 1e-40}));
}

} // namespace tokay::geometry
