// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/Polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// The letter U, counter-clockwise.
const Polygon notConvex = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

} // namespace

TEST(Polygon, the_intersection_of_shifted_squares_has_its_exact_area) {
    for (const double shift : {0.0, 1e-12, 0.25, 0.5, 0.999}) {
        Polygon other = square;
        for (Eigen::Vector2d& corner : other) {
            corner += Eigen::Vector2d(shift, -0.5 * shift);
        }
        EXPECT_NEAR(signedArea(clippedByConvex(other, square)), (1 - shift) * (1 - 0.5 * shift),
                    1e-15);
    }
}

TEST(Polygon, what_lies_apart_has_no_intersection) {
    Polygon other = square;
    for (Eigen::Vector2d& corner : other) {
        corner += Eigen::Vector2d(1.5, 0);
    }
    EXPECT_TRUE(clippedByConvex(other, square).empty());
}

TEST(Polygon, cutting_a_polygon_that_is_not_convex_keeps_its_area) {
    EXPECT_EQ(signedArea(notConvex), 5);
    // Both arms of the U, joined by sides that cancel.
    EXPECT_EQ(signedArea(clippedByHalfPlane(notConvex, {0, -1}, -1.5)), 1);
    EXPECT_EQ(signedArea(clippedByRectangle(notConvex, {0.5, 0.5}, {2.5, 1.5})), 2.0 - 0.5);
}

TEST(Polygon, the_parts_of_a_cut_sum_to_the_whole) {
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d normal(std::cos(i), std::sin(i));
        const double offset = 2 * std::sin(2.7 * i);
        const double parts = signedArea(clippedByHalfPlane(notConvex, normal, offset)) +
                             signedArea(clippedByHalfPlane(notConvex, -normal, -offset));
        EXPECT_NEAR(parts, 5, 1e-14);
    }
}

} // namespace tokay::geometry
