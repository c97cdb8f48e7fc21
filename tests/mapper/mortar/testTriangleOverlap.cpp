// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/triangleRule.hpp"
#include "mapper/intersection/TriangleOverlap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::mapper {

using geometry::Barycentric;
using geometry::Point;
using geometry::Triangle;

namespace {

const Triangle below({0, 0, 0}, {2, 0, 0}, {0, 2, 0});

Triangle moved(const Triangle& triangle, const Point& by) {
    return {triangle.corner(0) + by, triangle.corner(1) + by, triangle.corner(2) + by};
}

} // namespace

TEST(TriangleOverlap, of_a_shifted_triangle_is_a_smaller_one) {
    for (const double shift : {0.0, 0.25, 1.0, 1.999}) {
        const TriangleOverlap overlap(below, moved(below, Point(shift, 0, 0.3)));
        const double side = 1 - 0.5 * shift;
        EXPECT_NEAR(overlap.share(), side * side, 1e-15) << shift;
    }
}

TEST(TriangleOverlap, is_the_same_whichever_way_the_other_triangle_faces) {
    const Triangle above({-0.3, 0.4, 1}, {1.5, -0.2, 2}, {1.1, 1.7, -1}),
        turned(above.corner(0), above.corner(2), above.corner(1));
    const TriangleOverlap overlap(below, above), other(below, turned);
    EXPECT_GT(overlap.share(), 0.1);
    EXPECT_NEAR(overlap.share(), other.share(), 1e-15);
    EXPECT_LT((overlap.middle() - other.middle()).norm(), 1e-15);
}

TEST(TriangleOverlap, of_two_triangles_with_a_hexagon_in_common_consists_of_its_parts) {
    // The other triangle is this one turned by half about its centre: it cuts off each corner
    // by a third of the sides, 1 / 9 of the area.
    const Point centre(2.0 / 3, 2.0 / 3, 0);
    const auto opposite = [&](int i) -> Point { return 2 * centre - below.corner(i); };
    const TriangleOverlap overlap(below, {opposite(0), opposite(1), opposite(2)});
    ASSERT_EQ(overlap.nCorners(), 6);
    double sum = 0;
    for (int i = 1; i + 1 < overlap.nCorners(); ++i) {
        EXPECT_GT(overlap.share(i), 0.05);
        sum += overlap.share(i);
    }
    EXPECT_NEAR(sum, 2.0 / 3, 1e-15);
    EXPECT_NEAR(overlap.share(), sum, 1e-15);
    EXPECT_LT((overlap.middle() - Barycentric::Constant(1.0 / 3)).norm(), 1e-15);
    for (int i = 0; i < 6; ++i) {
        EXPECT_GE(overlap.corner(i).minCoeff(), 0);
    }
}

TEST(TriangleOverlap, of_a_triangle_with_itself_has_the_moments_of_barycentric_coordinates) {
    // a! b! c! 2! / (a + b + c + 2)! of the products of powers a, b, c
    Eigen::Matrix3d exact = Eigen::Matrix3d::Constant(1.0 / 12);
    exact.diagonal().setConstant(1.0 / 6);
    EXPECT_LT((TriangleOverlap(below, below).moments() - exact).norm(), 1e-15);
}

TEST(TriangleOverlap, has_the_moments_that_a_quadrature_rule_finds) {
    const Triangle above({-0.3, 0.4, 1}, {1.5, -0.2, 2}, {1.1, 1.7, -1});
    for (const Triangle& other :
         {above, Triangle(above.corner(0), above.corner(2), above.corner(1))}) {
        const TriangleOverlap overlap(below, other);
        ASSERT_GT(overlap.nCorners(), 4);
        const geometry::TriangleRule& rule = geometry::triangleRule(2);
        Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
        for (int i = 1; i + 1 < overlap.nCorners(); ++i) {
            Eigen::Matrix3d corners;
            corners << overlap.corner(0), overlap.corner(i), overlap.corner(i + 1);
            for (std::size_t k = 0; k < rule.points.size(); ++k) {
                const Barycentric at = corners * rule.points[k];
                moments += overlap.share(i) * rule.weights[k] * at * at.transpose();
            }
        }
        EXPECT_LT((overlap.moments() - moments).norm(), 1e-15);
    }
}

TEST(TriangleOverlap, of_triangles_apart_is_nothing) {
    EXPECT_EQ(TriangleOverlap(below, moved(below, Point(2.1, 0, 0))).share(), 0);
    EXPECT_EQ(TriangleOverlap(below, moved(below, Point(-1.5, -1.5, 0))).share(), 0);
}

} // namespace tokay::mapper
