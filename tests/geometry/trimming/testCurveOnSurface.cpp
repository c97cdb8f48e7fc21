// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/parameterCrossings.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/refinement.hpp"
#include "geometry/trimming/CurveOnSurface.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

const double pi = std::acos(-1.0);

/// A circle in the parameter space of the sample surface.
CurveOnSurface circleOnSurface() {
    return CurveOnSurface(arc(Point(0.5, 0.5, 0), 0.35, 0.1, 0.1 + 2 * pi), sampleSurface());
}

} // namespace

TEST(ParameterCrossings, finds_where_a_circle_crosses_a_line) {
    const NurbsCurve circle = arc(Point::Zero(), 1, 0.2, 0.2 + 2 * pi);
    for (const double value : {-0.99, -0.5, 0.0, 0.3, 0.999}) {
        const std::vector<double> crossings = parameterCrossings(circle, 0, value);
        ASSERT_EQ(crossings.size(), 2u) << value;
        for (const double t : crossings) {
            EXPECT_NEAR(circle.point(t)[0], value, 1e-15 * 4);
        }
    }
    EXPECT_TRUE(parameterCrossings(circle, 1, 1.01).empty());
}

TEST(ParameterCrossings, finds_a_crossing_exactly_between_two_spans) {
    const NurbsCurve curve = refine(line(Point(0, 0, 0), Point(1, 2, 0)), 2, 4);
    EXPECT_EQ(parameterCrossings(curve, 0, 0.5), std::vector<double>{0.5});
    EXPECT_TRUE(parameterCrossings(line(Point(1, 0, 0), Point(1, 1, 0)), 0, 1).empty());
}

TEST(CurveOnSurface, lies_on_the_surface_and_its_derivatives_agree_with_finite_differences) {
    const CurveOnSurface curve = circleOnSurface();
    const double h = 1e-5; // error h^2 and 1e-16 / h of each derivative's scale
    for (const double t : {0.1, 0.33, 0.62, 0.9}) {
        const Point at = curve.parameterCurve().point(t);
        const Points d = curve.derivatives(t, 2);
        EXPECT_LT((d.row(0).transpose() - curve.surface().point(at[0], at[1])).norm(), 1e-14);
        const Points difference =
            (curve.derivatives(t + h, 1) - curve.derivatives(t - h, 1)) / (2 * h);
        EXPECT_LT((difference.row(0) - d.row(1)).norm(), 1e-6 * d.norm());
        EXPECT_LT((difference.row(1) - d.row(2)).norm(), 1e-6 * d.norm());
    }
}

TEST(CurveOnSurface, breakpoints_are_the_crossings_of_knot_lines) {
    const CurveOnSurface curve = circleOnSurface();
    int nOnLines = 0;
    for (const double t : curve.breakpoints()) {
        const Point at = curve.parameterCurve().point(t);
        const double distance =
            std::min({std::abs(at[0] - 0.4), std::abs(at[1] - 0.5), std::abs(at[1] - 0.8)});
        nOnLines += distance < 1e-14;
    }
    EXPECT_EQ(nOnLines, 6);                     // each of three lines twice
    EXPECT_EQ(curve.breakpoints().size(), 11u); // and the arc's own four spans
}

TEST(CurveOnSurface, finds_the_parameter_of_points_on_it) {
    const CurveOnSurface curve = circleOnSurface();
    for (const double t : sampleParameters(101)) {
        if (t == 0 || t == 1) {
            continue; // the seam: either end is right
        }
        const CurveProjection found = curve.closest(curve.derivatives(t, 0).row(0));
        EXPECT_TRUE(found.converged);
        EXPECT_NEAR(found.xi, t, 1e-12);
        EXPECT_LT(found.distance, 1e-13);
    }
}

TEST(CurveOnSurface, refuses_a_curve_outside_the_patch) {
    expectInputError(
        [] { CurveOnSurface(line(Point(0.5, 0, 0), Point(0.5, 1.2, 0)), sampleSurface()); },
        {"eta", "1.2", "0 to 1"});
}

TEST(GaussLegendre, integrates_polynomials_of_twice_its_points_exactly) {
    for (int n = 1; n <= 24; ++n) {
        const QuadratureRule& rule = gaussLegendre(n);
        for (int degree = 0; degree < 2 * n; ++degree) {
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                sum += rule.weights[i] * std::pow(rule.points[i], degree);
            }
            EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-15 * 4) << n << " points, degree " << degree;
        }
    }
}

} // namespace tokay::geometry
