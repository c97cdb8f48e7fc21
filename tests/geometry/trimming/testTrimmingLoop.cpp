// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/sampleLoops.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/trimming/TrimmingLoop.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {
const double pi = std::acos(-1.0);
}

TEST(CurveParts, a_reversed_curve_has_the_same_points_backwards) {
    const NurbsCurve curve = sampleCurve(), back = reversed(curve);
    for (const double xi : sampleParameters(57)) {
        EXPECT_LT((curve.point(xi) - back.point(1 - xi)).norm(), 2e-14); // coordinates of size 6
    }
    EXPECT_EQ(back.point(0), curve.point(1));
}

TEST(CurveParts, a_part_is_the_curve_itself) {
    const NurbsCurve curve = sampleCurve();
    for (const auto& [from, to] :
         {std::pair(0.0, 1.0), std::pair(0.1, 0.2), std::pair(0.3, 0.7), std::pair(0.25, 1.0),
          std::pair(0.0, 0.7), std::pair(0.6999, 0.7001)}) {
        const NurbsCurve part = partOf(curve, from, to);
        EXPECT_EQ(part.knotVector().first(), from);
        EXPECT_EQ(part.knotVector().last(), to);
        for (const double t : sampleParameters(21)) {
            const double xi = from + t * (to - from);
            EXPECT_LT((curve.point(xi) - part.point(xi)).norm(), 2e-14);
        }
    }
    expectInputError([&] { partOf(curve, 0.5, 0.5); }, {"0.5 to 0.5"});
    expectInputError([&] { partOf(curve, 0.5, 1.5); }, {"0 to 1", "0.5 to 1.5"});
}

TEST(TrimmingLoop, its_area_is_exact_and_its_pieces_are_monotone) {
    EXPECT_NEAR(circleLoop(LoopKind::outer, {3, 4}, 2).signedArea(), 4 * pi, 1e-13);
    EXPECT_NEAR(circleLoop(LoopKind::inner, {3, 4}, 2).signedArea(), -4 * pi, 1e-13);
    EXPECT_NEAR(polygonLoop(LoopKind::outer, {{0, 0}, {4, 0}, {4, 1}, {1, 3}}).signedArea(), 7.5,
                1e-14);
    const TrimmingLoop circle = circleLoop(LoopKind::outer, {0, 0}, 1);
    for (const PlaneBezier& piece : circle.pieces()) {
        for (int axis = 0; axis < 2; ++axis) {
            const double sign = piece.end()[axis] - piece.start()[axis];
            for (const double t : sampleParameters(33)) { // the tangent has length 1
                EXPECT_GE(sign * piece.tangent(t).derivative[axis], -1e-14);
            }
        }
    }
}

TEST(TrimmingLoop, winds_once_around_inside_and_not_outside) {
    const TrimmingLoop circle = circleLoop(LoopKind::outer, {0.5, 0.5}, 0.4);
    for (const double angle : sampleParameters(101)) {
        const Parameters direction(std::cos(2 * pi * angle), std::sin(2 * pi * angle));
        EXPECT_EQ(circle.winding(Parameters(0.5, 0.5) + 0.4 * (1 - 1e-13) * direction), 1);
        EXPECT_EQ(circle.winding(Parameters(0.5, 0.5) + 0.4 * (1 + 1e-13) * direction), 0);
    }
    EXPECT_EQ(circleLoop(LoopKind::inner, {0.5, 0.5}, 0.4).winding({0.5, 0.5}), -1);
}

TEST(TrimmingLoop, closes_small_gaps_to_the_bit) {
    const double gap = 1e-8;
    const TrimmingLoop loop(LoopKind::outer, {line(Point(0, 0, 0), Point(1, gap, 0)),
                                              line(Point(1, 0, 0), Point(0.5, 1, 0)),
                                              line(Point(0.5 + gap, 1, 0), Point(0, 0, 0))});
    const auto& pieces = loop.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].end(), pieces[(i + 1) % pieces.size()].start());
    }
    EXPECT_NEAR(loop.signedArea(), 0.5, gap);
}

TEST(TrimmingLoop, its_polygon_stays_within_the_chord_tolerance) {
    const TrimmingLoop circle = circleLoop(LoopKind::outer, {0, 0}, 1);
    std::size_t before = 0;
    for (const double tolerance : {1e-1, 1e-3, 1e-5}) {
        const Polygon polygon = circle.tessellated(Parameters::Constant(tolerance));
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Parameters middle = 0.5 * (polygon[i] + polygon[(i + 1) % polygon.size()]);
            EXPECT_GE(middle.norm(), 1 - tolerance);
        }
        EXPECT_GT(polygon.size(), before);
        before = polygon.size();
    }
    EXPECT_LT(before, 4096u) << "chords get too short";
}

TEST(TrimmingLoop, refuses_open_loops_and_says_where) {
    expectInputError([] { TrimmingLoop(LoopKind::outer, {}); }, {"no curve"});
    expectInputError(
        [] {
            TrimmingLoop(LoopKind::outer, {line(Point(0, 0, 0), Point(1, 0, 0)),
                                           line(Point(1, 0, 0), Point(1, 1, 0)),
                                           line(Point(0, 0.9, 0), Point(0, 0, 0))});
        },
        {"open", "curve 1 ends at (1, 1)", "curve 2 starts at (0, 0.9)"});
    expectInputError([] { TrimmingLoop(LoopKind::outer, {arc(Point::Zero(), 1, 0, 3)}); },
                     {"open", "(1, 0)"});
}

TEST(TrimmingLoop, refuses_the_wrong_direction) {
    const Polygon corners = {{0, 0}, {1, 0}, {1, 1}};
    expectInputError([&] { polygonLoop(LoopKind::inner, corners); },
                     {"inner", "counter-clockwise", "reverse"});
    expectInputError(
        [&] {
            polygonLoop(LoopKind::outer, {corners[0], corners[2], corners[1]});
        },
        {"outer", "must run counter-clockwise"});
}

TEST(TrimmingLoop, refuses_crossings_touches_and_spikes) {
    // A bow tie with unequal wings, so that it has an area.
    expectInputError(
        [] {
            polygonLoop(LoopKind::outer, {{0, 0}, {3, 0}, {0, 2}, {3, 2}});
        },
        {"crosses or touches itself at (1.5, 1)"});
    // A corner that touches the opposite side.
    expectInputError(
        [] {
            polygonLoop(LoopKind::outer, {{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}});
        },
        {"touches itself at (1, 0)"});
    // There and back on the same line.
    expectInputError(
        [] {
            polygonLoop(LoopKind::outer, {{0, 0}, {1, 0}, {1, 1}, {2, 2}, {1, 1.0}, {0, 1}});
        },
        {"touches itself"});
    // A cubic with a loop of its own.
    Points points(4, 3);
    points << 0, 0, 0, 3, 2, 0, -2, 2, 0, 1, 0, 0;
    expectInputError(
        [&] {
            TrimmingLoop(LoopKind::inner, {NurbsCurve(KnotVector::uniform(3, 1), points),
                                           line(Point(1, 0, 0), Point(0, 0, 0))});
        },
        {"crosses or touches itself at (0.5"});
}

TEST(TrimmingLoop, accepts_cusps_and_narrow_slits) {
    // Two circles touch at the origin: the loop leaves it and returns in one direction.
    const TrimmingLoop cusp(LoopKind::outer, {arc(Point(0, 2, 0), 2, -pi / 2, pi / 2),
                                              line(Point(0, 4, 0), Point(0, 2, 0)),
                                              reversed(arc(Point(0, 1, 0), 1, -pi / 2, pi / 2))});
    EXPECT_NEAR(cusp.signedArea(), 1.5 * pi, 1e-13);
    const double width = 1e-8;
    const TrimmingLoop slit = polygonLoop(
        LoopKind::outer, {{0, 0}, {1, 0}, {1, 1}, {0.5 + width, 1}, {0.5, 0.2}, {0.5, 1}, {0, 1}});
    EXPECT_NEAR(slit.signedArea(), 1 - 0.4 * width, 1e-15);
}

TEST(TrimmingLoop, scale_and_position_do_not_matter) {
    for (const double scale : {1e-9, 1e9}) {
        for (const double shift : {0.0, 1e5}) {
            const double s = scale, o = shift * scale;
            EXPECT_NO_THROW(polygonLoop(LoopKind::outer, {{o, o}, {o + s, o}, {o + s, o + s}}));
            EXPECT_THROW(polygonLoop(LoopKind::outer,
                                     {{o, o}, {o + 3 * s, o}, {o, o + 2 * s}, {o + 3 * s, o + s}}),
                         InputError);
        }
    }
}

} // namespace tokay::geometry
