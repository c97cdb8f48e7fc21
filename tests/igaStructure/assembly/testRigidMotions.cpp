// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/RigidMotions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

const Vector3d x = Vector3d::UnitX();
const Vector3d y = Vector3d::UnitY();
const Vector3d z = Vector3d::UnitZ();

// Of a box of 4 x 2 x 2 that begins at (10, 0, 0).
RigidMotions ofBox() {
    geometry::Points points(2, 3);
    points << 10, 0, 0, 14, 2, 2;
    return RigidMotions(points);
}

void pin(RigidMotions& motions, const geometry::Point& point) {
    for (const Vector3d& direction : {x, y, z}) {
        motions.holdPoint(point, direction);
    }
}

} // namespace

TEST(RigidMotions, body_without_supports_has_all_six) {
    EXPECT_THAT(ofBox().freeOnes(),
                ElementsAre("translation along x", "translation along y", "translation along z",
                            "rotation about x", "rotation about y", "rotation about z"));
}

TEST(RigidMotions, body_of_the_plane_has_three) {
    RigidMotions motions = ofBox();
    motions.holdInPlane();
    EXPECT_THAT(motions.freeOnes(),
                ElementsAre("translation along x", "translation along y", "rotation about z"));
}

TEST(RigidMotions, hinges_leave_the_rotation_about_their_axis) {
    RigidMotions motions = ofBox();
    pin(motions, {10, 0, 2});
    EXPECT_THAT(motions.freeOnes(), ElementsAre("rotation about x through (12, 0, 2)",
                                                "rotation about y through (10, 1, 2)",
                                                "rotation about z through (10, 0, 1)"));
    pin(motions, {10, 2, 2});
    EXPECT_THAT(motions.freeOnes(), ElementsAre("rotation about y through (10, 1, 2)"));
    motions.holdRotation(y);
    EXPECT_THAT(motions.freeOnes(), IsEmpty());
}

TEST(RigidMotions, axes_may_lie_oblique) {
    RigidMotions motions = ofBox();
    pin(motions, {10, 0, 1});
    pin(motions, {12, 2, 1});
    // The foot of the centre (12, 1, 1) on the line through both is (11.5, 1.5, 1).
    EXPECT_THAT(motions.freeOnes(),
                ElementsAre("rotation about (0.7071, 0.7071, 0) through (11.5, 1.5, 1)"));
    RigidMotions guided = ofBox();
    for (const geometry::Point& point : {geometry::Point(10, 0, 0), geometry::Point(14, 0, 0),
                                         geometry::Point(10, 2, 0), geometry::Point(10, 0, 2)}) {
        guided.holdPoint(point, z);
        guided.holdPoint(point, (x + y).normalized());
    }
    EXPECT_THAT(guided.freeOnes(), ElementsAre("translation along (0.7071, -0.7071, 0)"));
}

TEST(RigidMotions, a_nut_moves_along_its_bolt) {
    RigidMotions motions = ofBox();
    pin(motions, {10, 1, 1});
    pin(motions, {14, 1, 1});
    EXPECT_THAT(motions.freeOnes(), ElementsAre("rotation about x through (12, 1, 1)"));
    RigidMotions nut = ofBox();
    for (const double at : {10.0, 14.0}) {
        nut.holdPoint({at, 1, 1}, y);
        nut.holdPoint({at, 1, 1}, z);
    }
    Eigen::RowVectorXd thread(6);
    thread << 1, 0, 0, -0.1, 0, 0;
    nut.hold(thread);
    EXPECT_THAT(nut.freeOnes(),
                ElementsAre("rotation about x through (12, 1, 1) that moves along it"));
}

TEST(RigidMotions, a_tiny_support_holds) {
    RigidMotions motions = ofBox();
    for (const geometry::Point& point :
         {geometry::Point(10, 0, 0), geometry::Point(10, 1e-5, 0), geometry::Point(10, 0, 1e-5)}) {
        pin(motions, point);
    }
    EXPECT_THAT(motions.freeOnes(), IsEmpty());
}
