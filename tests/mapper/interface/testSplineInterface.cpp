// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "mapper/interface/SplineInterface.hpp"
#include "mapper/sampleInterfaces.hpp"

#include <gtest/gtest.h>

namespace tokay::mapper {

TEST(SplineInterface, locates_points_on_the_right_piece) {
    const SplineInterface interface = flapInterface();
    EXPECT_EQ(interface.closest(Point(-0.06, 0.4, 0)).piece, 0);
    EXPECT_EQ(interface.closest(Point(0.01, 1.1, 0)).piece, 1);
    EXPECT_EQ(interface.closest(Point(0.04, 0.3, 0)).piece, 2);
    EXPECT_NEAR(interface.locate(Point(0.04, 0.3, 0)).gap, 0.01, 1e-15);
}

TEST(SplineInterface, a_corner_of_two_pieces_is_one_place) {
    const Location corner = flapInterface().locate(Point(-0.05, 1, 0));
    EXPECT_FALSE(corner.ambiguous);
    EXPECT_LT(corner.gap, 1e-15);
    int nWeights = 0;
    for (const double weight : corner.weights) {
        nWeights += std::abs(weight) > 1e-14;
    }
    EXPECT_EQ(nWeights, 1) << "a corner is a control point";
}

TEST(SplineInterface, the_point_in_the_middle_of_the_flap_is_ambiguous) {
    EXPECT_TRUE(flapInterface().locate(Point(0, 0.5, 0)).ambiguous);
    EXPECT_FALSE(flapInterface().locate(Point(0.001, 0.5, 0)).ambiguous);
}

TEST(SplineInterface, the_centre_of_an_arc_is_ambiguous) {
    EXPECT_TRUE(quarterCircle(2, 3).locate(Point::Zero()).ambiguous);
    EXPECT_FALSE(quarterCircle(2, 3).locate(Point(0.2, 0.1, 0)).ambiguous);
}

TEST(SplineInterface, refuses_pieces_that_do_not_fit_the_structure) {
    const geometry::NurbsCurve line = geometry::line(Point::Zero(), Point(1, 0, 0));
    const geometry::NurbsCurve other = geometry::line(Point(1, 0.5, 0), Point(2, 0, 0));
    expectInputError([&] { SplineInterface({}, 4); }, {"no piece"});
    expectInputError(
        [&] {
            SplineInterface({{line, {0, 1, 2}, "plate.top"}}, 4);
        },
        {"plate.top", "3", "2"});
    expectInputError(
        [&] {
            SplineInterface({{line, {0, 4}, "plate.top"}}, 4);
        },
        {"plate.top", "control point 4", "has 4"});
    expectInputError(
        [&] {
            SplineInterface({{line, {0, 1}, "first"}, {other, {1, 2}, "second"}}, 4);
        },
        {"control point 1", "second", "0.5"});
    // The limit is rounding, 1e-9 of the size of 2.
    const auto apart = [&](double distance) {
        const geometry::NurbsCurve next = geometry::line(Point(1, distance, 0), Point(2, 0, 0));
        SplineInterface({{line, {0, 1}, "first"}, {next, {1, 2}, "second"}}, 3);
    };
    EXPECT_NO_THROW(apart(1e-10));
    expectInputError([&] { apart(1e-8); }, {"control point 1", "second", "1e-08"});
}

} // namespace tokay::mapper
