// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/spline/openSpline.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

namespace {

/// By the recursion of Cox and de Boor, for any knot vector.
double basisFunction(const std::vector<double>& knots, int i, int degree, double xi) {
    if (degree == 0) {
        return knots[i] <= xi && xi < knots[i + 1] ? 1 : 0;
    }
    double value = 0;
    if (knots[i + degree] > knots[i]) {
        value += (xi - knots[i]) / (knots[i + degree] - knots[i]) *
                 basisFunction(knots, i, degree - 1, xi);
    }
    if (knots[i + degree + 1] > knots[i + 1]) {
        value += (knots[i + degree + 1] - xi) / (knots[i + degree + 1] - knots[i + 1]) *
                 basisFunction(knots, i + 1, degree - 1, xi);
    }
    return value;
}

double valueOf(const SplineCoefficients& spline, double xi) {
    const int span = spline.knots.findSpan(xi), p = spline.knots.degree();
    return (spline.knots.basisDerivatives(span, xi, 0) *
            spline.rows.middleRows(span - p, p + 1))(0, 0);
}

} // namespace

TEST(OpenSpline, keeps_the_values_of_periodic_and_half_open_splines) {
    const std::vector<std::vector<double>> knotVectors = {
        {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7},
        {-3, -2.5, 0, 0, 1, 2, 2.5, 4, 4, 6, 7},
        {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7},
        {-1, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4},
    };
    for (const std::vector<double>& knots : knotVectors) {
        Eigen::MatrixXd rows(7, 1);
        rows << 1, -2, 4, 0.5, 3, -1, 2;
        const SplineCoefficients spline = openSpline(3, knots, rows);
        EXPECT_EQ(spline.knots.first(), knots[3]);
        EXPECT_EQ(spline.knots.last(), knots[7]);
        for (int k = 0; k < 50; ++k) {
            const double xi = knots[3] + (knots[7] - knots[3]) * k / 50;
            double value = 0;
            for (int i = 0; i < 7; ++i) {
                value += basisFunction(knots, i, 3, xi) * rows(i, 0);
            }
            EXPECT_NEAR(valueOf(spline, xi), value, 1e-14);
        }
    }
}

TEST(OpenSpline, leaves_open_splines_as_they_are_to_the_bit) {
    Eigen::MatrixXd rows(4, 2);
    rows << 1, 2, 3, 4, 5, 6, 0.1, 0.7;
    for (const std::vector<double>& knots :
         {std::vector<double>{0, 0, 0, 0.3, 1, 1, 1}, std::vector<double>{0, 0, 0.3, 1, 1}}) {
        const SplineCoefficients spline = openSpline(2, knots, rows);
        EXPECT_EQ(spline.rows, rows);
        EXPECT_EQ(spline.knots.knots(), (std::vector<double>{0, 0, 0, 0.3, 1, 1, 1}));
    }
}

TEST(OpenSpline, refuses_what_fits_neither_way) {
    const Eigen::MatrixXd rows = Eigen::MatrixXd::Ones(3, 1);
    expectInputError([&] { openSpline(2, {0, 0, 0, 1, 1}, rows); }, {"5 knots", "6", "(or 4"});
    expectInputError([&] { openSpline(2, {0, 0, 0, 1, 0.5, 1}, rows); }, {"knot 4", "0.5"});
    expectInputError([&] { openSpline(2, {0, 0, 1, 1, 2, 2}, rows); }, {"no range"});
    expectInputError([&] { openSpline(0, {0, 1}, rows); }, {"degree is 0"});
}

} // namespace tokay::geometry
