// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {
const double pi = std::acos(-1.0);
}

TEST(Primitives, arcs_of_any_angle_are_exact_circles) {
    const Point centre(3, -2, 0.5);
    for (const double angle : {0.1, pi / 2, 2.0, pi, 5.0, 2 * pi}) {
        const NurbsCurve curve = arc(centre, 0.7, 0.4, 0.4 + angle);
        for (const double xi : sampleParameters(57)) {
            const Point radius = curve.point(xi) - centre;
            EXPECT_NEAR(radius.norm(), 0.7, 1e-15 * 10); // coordinates of size 3
            EXPECT_NEAR(radius[2], 0, 1e-15);            // rational: z is a quotient
        }
        const Point end = centre + 0.7 * Point(std::cos(0.4 + angle), std::sin(0.4 + angle), 0);
        EXPECT_LT((curve.point(1) - end).norm(), 1e-14);
    }
}

TEST(Primitives, a_refined_full_circle_stays_exact_and_closed) {
    const NurbsCurve circle = refine(arc(Point::Zero(), 1, 0, 2 * pi), 4, 7);
    EXPECT_EQ(circle.point(0), circle.point(1));
    for (const double xi : sampleParameters(201)) {
        EXPECT_NEAR(circle.point(xi).norm(), 1, 5e-15);
    }
}

TEST(Primitives, rectangle_edges_are_where_one_sees_them) {
    const NurbsSurface surface = rectangle(Point(1, 2, 0), 3, 4);
    const auto middle = [&](Edge edge) { return surface.boundaryCurve(edge).curve.point(0.5); };
    EXPECT_EQ(middle(Edge::left), Point(1, 4, 0));
    EXPECT_EQ(middle(Edge::right), Point(4, 4, 0));
    EXPECT_EQ(middle(Edge::bottom), Point(2.5, 2, 0));
    EXPECT_EQ(middle(Edge::top), Point(2.5, 6, 0));
}

TEST(Primitives, ring_sector_lies_between_its_radii) {
    const NurbsSurface ring = ringSector(Point(1, 1, 0), 0.95, 1.05, 0, 2 * pi);
    for (const double xi : sampleParameters(5)) {
        for (const double eta : sampleParameters(33)) {
            EXPECT_NEAR((ring.point(xi, eta) - Point(1, 1, 0)).norm(), 0.95 + 0.1 * xi, 3e-15);
        }
    }
    const Points d = ring.derivatives(0.5, 0.3, 1);
    EXPECT_GT(d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0), 0) << "xi, eta must be right-handed";
}

TEST(Primitives, cylinder_patch_is_exact_and_its_normal_points_outwards) {
    const NurbsSurface cylinder = cylinderPatch(Point(1, 2, 3), 0.5, 2, 0.3, 0.3 + 1.5 * pi);
    for (const double xi : sampleParameters(33)) {
        for (const double eta : sampleParameters(5)) {
            const Points d = cylinder.derivatives(xi, eta, 1);
            const Point radius(d(0, 0) - 1, d(0, 1) - 2, 0);
            EXPECT_NEAR(radius.norm(), 0.5, 3e-15);
            EXPECT_NEAR(d(0, 2), 3 + 2 * eta, 3e-15);
            const Point a = d.row(1), b = d.row(2);
            const Point normal(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                               a[0] * b[1] - a[1] * b[0]);
            EXPECT_GT(normal.normalized().dot(radius) / 0.5, 1 - 1e-14);
        }
    }
}

TEST(Primitives, impossible_sizes_are_refused_by_name) {
    expectInputError([] { line(Point::Zero(), Point::Zero()); }, {"length of the line", "0"});
    expectInputError([] { arc(Point::Zero(), -1, 0, 1); }, {"radius", "-1"});
    expectInputError([] { arc(Point::Zero(), 1, 1, 0); }, {"angle", "-1"});
    expectInputError([] { arc(Point::Zero(), 1, 0, 7); }, {"7 rad", "full turn"});
    expectInputError([] { rectangle(Point::Zero(), 1, NAN); }, {"along y", "nan"});
    expectInputError([] { ringSector(Point::Zero(), 1, 0.9, 0, 1); }, {"thickness"});
    expectInputError([] { plate(Point::Zero(), Point(1, 1, 0), Point(2, 2, 0)); }, {"parallel"});
}

} // namespace tokay::geometry
