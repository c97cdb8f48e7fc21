// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/NurbsCurve.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

TEST(NurbsCurve, rational_functions_sum_to_one_and_are_not_negative) {
    const NurbsCurve curve = sampleCurve();
    for (const double xi : sampleParameters(33)) {
        const CurveBasis basis = curve.basis(xi, 2);
        EXPECT_NEAR(basis.N.row(0).sum(), 1, 1e-14);
        EXPECT_GE(basis.N.row(0).minCoeff(), 0);
        EXPECT_NEAR(basis.N.row(1).sum(), 0, 1e-13 * basis.N.row(1).norm());
        EXPECT_NEAR(basis.N.row(2).sum(), 0, 1e-13 * basis.N.row(2).norm());
    }
}

TEST(NurbsCurve, derivatives_agree_with_finite_differences) {
    const NurbsCurve curve = sampleCurve();
    const double h = 1e-5; // error h^2 and 1e-16 / h of each derivative's scale
    for (const double xi : {0.11, 0.45, 0.66, 0.83}) {
        const Points exact = curve.derivatives(xi, 4);
        const Points ahead = curve.derivatives(xi + h, 4), behind = curve.derivatives(xi - h, 4);
        for (int k = 0; k < 4; ++k) {
            EXPECT_LT(((ahead.row(k) - behind.row(k)) / (2 * h) - exact.row(k + 1)).norm(),
                      1e-6 * (exact.row(k).norm() + exact.row(k + 1).norm() + exact.row(4).norm()))
                << "derivative " << k + 1 << " at " << xi;
        }
    }
}

TEST(NurbsCurve, starts_and_ends_at_its_outer_control_points) {
    const NurbsCurve curve = sampleCurve();
    EXPECT_EQ(curve.point(0), Point(0, 0, 0));
    EXPECT_EQ(curve.point(1), Point(6, 0, 0));
}

TEST(NurbsCurve, equal_weights_make_a_polynomial_curve) {
    const NurbsCurve curve = curveWithCorner();
    const NurbsCurve weighted(curve.knotVector(), curve.controlPoints(),
                              Eigen::VectorXd::Constant(5, 0.7));
    EXPECT_FALSE(weighted.isRational());
    EXPECT_EQ(weighted.point(0.3), curve.point(0.3));
}

TEST(NurbsCurve, refuses_counts_weights_and_coordinates_that_do_not_fit) {
    const KnotVector knots = KnotVector::uniform(1, 2);
    const Points points = Points::Random(3, 3);
    expectInputError([&] { NurbsCurve(knots, points.topRows(2)); }, {"2 control points", "3"});
    expectInputError([&] { NurbsCurve(knots, points, Eigen::VectorXd::Ones(2)); }, {"2 weights"});
    expectInputError([&] { NurbsCurve(knots, points, Eigen::Vector3d(1, 0, 1)); },
                     {"weight 1", "positive"});
    Points broken = points;
    broken(2, 1) = NAN;
    expectInputError([&] { NurbsCurve(knots, broken); }, {"control point 2", "nan"});
}

} // namespace tokay::geometry
