// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/Triangle.hpp"
#include "geometry/quadrature/triangleRule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {
const Triangle triangle(Point(1, 0, 0), Point(3, 0.5, 1), Point(1.5, 2, -0.5));
}

TEST(Triangle, barycentric_coordinates_invert_the_position) {
    for (const Barycentric& b :
         {Barycentric(0.2, 0.3, 0.5), Barycentric(1.4, -0.9, 0.5), Barycentric(0, 0, 1)}) {
        const Point off = triangle.at(b) + 0.7 * triangle.unitNormal();
        EXPECT_LT((triangle.barycentric(off) - b).norm(), 1e-14);
    }
}

TEST(Triangle, no_point_of_it_is_nearer_than_the_closest) {
    for (int i = 0; i < 200; ++i) {
        const Point point(4 * std::sin(1.0 * i), 3 * std::cos(2.0 * i), 2 * std::sin(3.3 * i));
        const Barycentric found = triangle.closest(point);
        EXPECT_GE(found.minCoeff(), 0);
        EXPECT_NEAR(found.sum(), 1, 1e-15 * 4);
        const double distance = (triangle.at(found) - point).norm();
        for (int a = 0; a <= 20; ++a) {
            for (int b = 0; a + b <= 20; ++b) {
                const Barycentric other(a / 20.0, b / 20.0, (20 - a - b) / 20.0);
                EXPECT_LE(distance, (triangle.at(other) - point).norm() + 1e-14);
            }
        }
    }
}

TEST(Triangle, a_needle_keeps_its_coordinates) {
    const Triangle needle(Point(0, 0, 0), Point(1, 0, 0), Point(0.3, 1e-3, 0));
    const Barycentric b(0.1, 0.2, 0.7);
    // 1e-16 of the length is 1e-13 of the height.
    EXPECT_LT((needle.barycentric(needle.at(b)) - b).norm(), 1e-12);
}

TEST(TriangleRule, integrates_polynomials_of_its_degree_exactly) {
    const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
    for (int degree = 0; degree <= 12; ++degree) {
        const TriangleRule& rule = triangleRule(degree);
        for (int i = 0; i <= degree; ++i) {
            for (int j = 0; i + j <= degree; ++j) {
                double sum = 0;
                for (std::size_t k = 0; k < rule.points.size(); ++k) {
                    EXPECT_GT(rule.weights[k], 0);
                    sum += rule.weights[k] * std::pow(rule.points[k][1], i) *
                           std::pow(rule.points[k][2], j);
                }
                const double exact = 2 * factorial(i) * factorial(j) / factorial(i + j + 2);
                EXPECT_NEAR(sum, exact, 1e-15 * 3) << degree << ": " << i << ", " << j;
            }
        }
    }
}

} // namespace tokay::geometry
