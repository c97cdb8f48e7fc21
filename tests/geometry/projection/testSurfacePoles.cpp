// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/primitives.hpp"
#include "geometry/projection/surfacePoles.hpp"
#include "geometry/sampleGeometry.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

TEST(SurfacePoles, a_sphere_has_two_with_the_axis_as_normal) {
    const std::vector<Pole> poles = surfacePoles(sphere(Point(1, 2, 3), 2));
    ASSERT_EQ(poles.size(), 2);
    EXPECT_EQ(poles[0].edge, Edge::bottom);
    EXPECT_LT((poles[0].place - Point(1, 2, 1)).norm(), 1e-14);
    EXPECT_EQ(poles[1].edge, Edge::top);
    EXPECT_LT((poles[1].place - Point(1, 2, 5)).norm(), 1e-14);
    for (const Pole& pole : poles) {
        EXPECT_NEAR(std::abs(pole.normal[2]), 1, 1e-14);
    }
}

TEST(SurfacePoles, a_cones_tip_has_no_normal) {
    Points points(6, 3);
    points << 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1;
    const NurbsSurface cone(KnotVector::uniform(2, 1), KnotVector::uniform(1, 1), points);
    const std::vector<Pole> poles = surfacePoles(cone);
    ASSERT_EQ(poles.size(), 1);
    EXPECT_EQ(poles[0].edge, Edge::top);
    EXPECT_EQ(poles[0].normal.norm(), 0);
}

TEST(SurfacePoles, most_surfaces_have_none) {
    EXPECT_TRUE(surfacePoles(sampleSurface()).empty());
}

} // namespace tokay::geometry
