// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/polygonRegion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

Polygon ring(const Parameters& centre, double radius, int n, double sign) {
    Polygon polygon;
    for (int i = 0; i < n; ++i) {
        const double angle = sign * 2 * std::acos(-1.0) * i / n;
        polygon.push_back(centre + radius * Parameters(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

double area(const std::vector<PlaneTriangle>& triangles) {
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        EXPECT_GT(signedArea(Polygon{a, b, c}), 0);
        sum += signedArea(Polygon{a, b, c});
    }
    return sum;
}

} // namespace

TEST(PolygonRegion, intersections_of_cells_add_up_to_the_region) {
    const Region region = {ring({5, 5}, 4, 31, 1), ring({4, 6}, 1.3, 17, -1),
                           ring({6.5, 4}, 1.1, 12, -1)};
    double sum = 0;
    for (int j = 0; j < 10; ++j) {
        for (int i = 0; i < 10; ++i) {
            sum += signedArea(
                intersection(region, ParameterBox{Parameters(i, j), Parameters(i + 1, j + 1)}));
        }
    }
    EXPECT_NEAR(sum, signedArea(region), 1e-13);
}

TEST(PolygonRegion, triangles_cover_regions_with_holes) {
    const Region region = {ring({5, 5}, 4, 31, 1), ring({4, 6}, 1.3, 17, -1),
                           ring({6.5, 4}, 1.1, 12, -1), ring({3.5, 3.5}, 0.6, 9, -1),
                           ring({15, 5}, 2, 6, 1)};
    const auto triangles = triangulated(region);
    EXPECT_NEAR(area(triangles), signedArea(region), 1e-13);
    // n corners and h holes of a ring make n + 2 h - 2 triangles.
    EXPECT_EQ(triangles.size(), 31u + 17 + 12 + 9 + 2 * 3 - 2 + 6 - 2);
}

TEST(PolygonRegion, triangles_cover_combs_and_spirals) {
    Polygon comb = {{0, -1}, {20, -1}};
    for (int i = 20; i >= 0; --i) {
        comb.push_back({1.0 * i, i % 2 == 0 ? 3.0 : 0.1});
    }
    EXPECT_NEAR(area(triangulated({comb})), signedArea(comb), 1e-13);
    Polygon spiral;
    for (int i = 0; i <= 60; ++i) {
        spiral.push_back((1 + 0.1 * i) * Parameters(std::cos(0.3 * i), std::sin(0.3 * i)));
    }
    for (int i = 60; i >= 0; --i) {
        spiral.push_back((1.5 + 0.1 * i) * Parameters(std::cos(0.3 * i), std::sin(0.3 * i)));
    }
    if (signedArea(spiral) < 0) {
        std::reverse(spiral.begin(), spiral.end());
    }
    EXPECT_NEAR(area(triangulated({spiral})), signedArea(spiral), 1e-12);
}

TEST(PolygonRegion, disjoint_regions_have_no_intersection) {
    EXPECT_TRUE(intersection({ring({0, 0}, 1, 5, 1)}, {ring({3, 0}, 1, 5, 1)}).empty());
    EXPECT_TRUE(intersection({}, {ring({3, 0}, 1, 5, 1)}).empty());
    EXPECT_TRUE(triangulated({}).empty());
}

} // namespace tokay::geometry
