// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/sampleLoops.hpp"
#include "geometry/trimming/TrimmedPatch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

/// Unit square with nSpans elements a side, of which x > cut is trimmed away.
TrimmedPatch cutAt(double cut, int nSpans) {
    return TrimmedPatch(square(nSpans),
                        {polygonLoop(LoopKind::outer, {{0, 0}, {cut, 0}, {cut, 1}, {0, 1}})});
}

int count(const TrimmedPatch& patch, ElementState state) {
    return static_cast<int>(patch.elements(state).size());
}

} // namespace

TEST(TrimmedPatch, without_loops_every_element_is_full) {
    const TrimmedPatch patch(square(3));
    EXPECT_FALSE(patch.isTrimmed());
    EXPECT_EQ(count(patch, ElementState::full), 9);
    EXPECT_TRUE(patch.contains({0.5, 0.99}));
    EXPECT_FALSE(patch.contains({0.5, 1.01}));
}

TEST(TrimmedPatch, a_loop_on_the_rim_leaves_every_element_full) {
    const TrimmedPatch patch = cutAt(1, 7);
    EXPECT_FALSE(patch.isTrimmed());
    EXPECT_EQ(count(patch, ElementState::full), 49);
}

TEST(TrimmedPatch, a_trim_line_on_a_knot_line_cuts_no_element) {
    const int n = 7;
    for (int k = 1; k < n; ++k) {
        const TrimmedPatch patch = cutAt(static_cast<double>(k) / n, n);
        EXPECT_EQ(count(patch, ElementState::full), k * n);
        EXPECT_EQ(count(patch, ElementState::cut), 0);
    }
}

TEST(TrimmedPatch, a_trim_line_beside_a_knot_line_cuts_only_what_is_more_than_a_sliver) {
    const int n = 10;
    for (const double side : {-1.0, 1.0}) {
        for (const double distance : {1e-12, 1e-8, 1e-4}) {
            const TrimmedPatch patch = cutAt((3 + side * distance) / n, n);
            const bool isSliver = distance < TrimmedPatch::sliver;
            EXPECT_EQ(count(patch, ElementState::cut), isSliver ? 0 : n) << side * distance;
            EXPECT_EQ(count(patch, ElementState::full), isSliver || side > 0 ? 3 * n : 2 * n);
            for (const int element : patch.elements(ElementState::cut)) {
                double area = 0;
                for (const Tile& tile : patch.tiles(element)) {
                    area += tile.area();
                }
                // The cut's place is rounded to 1e-16, 1e-15 of an element.
                EXPECT_NEAR(area * n * n, side > 0 ? distance : 1 - distance, 1e-14);
            }
        }
    }
}

TEST(TrimmedPatch, a_trim_line_that_wobbles_about_a_knot_line_is_consistent) {
    // Corners by turns left and right of the knot line, some on it.
    for (const double size : {1e-16, 1e-13, 1e-9, 1e-5}) {
        Polygon corners = {{0, 0}};
        const int nCorners = 40;
        for (int i = 0; i <= nCorners; ++i) {
            corners.push_back({0.5 + size * (i % 3 - 1), static_cast<double>(i) / nCorners});
        }
        corners.push_back({0, 1});
        const TrimmingLoop loop = polygonLoop(LoopKind::outer, corners);
        const TrimmedPatch patch(square(4), {loop});
        double area = 0;
        for (int element = 0; element < patch.nElements(); ++element) {
            if (patch.state(element) == ElementState::full) {
                area += patch.elementBox(element).area();
            }
            for (const Tile& tile : patch.tiles(element)) {
                area += tile.area();
            }
        }
        EXPECT_NEAR(area, loop.signedArea(), 1e-12) << size; // slivers of 8 elements
    }
}

TEST(TrimmedPatch, a_hole_smaller_than_an_element_cuts_its_element_only) {
    const TrimmedPatch patch(square(4), {circleLoop(LoopKind::inner, {0.6, 0.6}, 0.05)});
    EXPECT_EQ(patch.elements(ElementState::cut), std::vector<int>{patch.elementNumber(2, 2)});
    EXPECT_EQ(count(patch, ElementState::full), 15);
    EXPECT_FALSE(patch.contains({0.6, 0.6}));
    EXPECT_FALSE(patch.contains({0.6, 0.6499}));
    EXPECT_TRUE(patch.contains({0.6, 0.6501}));
}

TEST(TrimmedPatch, contains_agrees_with_the_distance_to_the_centre) {
    const TrimmedPatch patch(square(9), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.45),
                                         circleLoop(LoopKind::inner, {0.5, 0.45}, 0.2)});
    for (int i = 0; i < 5000; ++i) {
        const Parameters point(0.5 + 0.5 * std::sin(1.3 * i), 0.5 + 0.5 * std::cos(0.7 * i + 1));
        const bool isInside = (point - Parameters(0.5, 0.5)).norm() < 0.45 &&
                              (point - Parameters(0.5, 0.45)).norm() > 0.2;
        EXPECT_EQ(patch.contains(point), isInside) << point.transpose();
    }
}

TEST(TrimmedPatch, an_island_in_a_hole_belongs_to_the_patch) {
    const TrimmedPatch patch(square(5), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.49),
                                         circleLoop(LoopKind::inner, {0.5, 0.5}, 0.4),
                                         circleLoop(LoopKind::outer, {0.5, 0.5}, 0.2)});
    EXPECT_TRUE(patch.contains({0.5, 0.5}));
    EXPECT_FALSE(patch.contains({0.5, 0.8}));
    EXPECT_TRUE(patch.contains({0.5, 0.95}));
}

TEST(TrimmedPatch, a_refined_basis_keeps_loops_and_parameters) {
    const TrimmedPatch patch(square(1), {circleLoop(LoopKind::inner, {0.5, 0.5}, 0.3)});
    const TrimmedPatch fine = patch.refined(3, 4, 6, 8);
    EXPECT_EQ(fine.nElements(), 48);
    EXPECT_EQ(fine.basis().v().degree(), 4);
    EXPECT_EQ(fine.surface().nControlPoints(), patch.surface().nControlPoints());
    EXPECT_LT((fine.basis().point(0.3, 0.7) - Point(0.3, 0.7, 0)).norm(), 1e-15);
    EXPECT_FALSE(fine.contains({0.5, 0.5}));
}

TEST(TrimmedPatch, clipped_cells_keep_the_area_inside_the_loops) {
    const double radius = 0.79;
    const TrimmedPatch patch(square(1), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.49),
                                         circleLoop(LoopKind::inner, {0.5, 0.5}, 0.3)});
    double area = 0; // cells that cover the element
    const int n = 6;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const Parameters lower(1.0 * i / n, 1.0 * j / n), size(1.0 / n, 1.0 / n);
            const Parameters right(size[0], 0), up(0, size[1]);
            for (const Polygon& part :
                 patch.clipped({lower, lower + right, lower + size, lower + up})) {
                area += signedArea(part);
            }
        }
    }
    const double exact = std::acos(-1.0) * (0.2401 - 0.09);
    // Chords lie inside the arcs; two thirds of the tolerance times the circumferences.
    EXPECT_NEAR(area, exact, TrimmedPatch::polygonTolerance * 2 * std::acos(-1.0) * radius);
}

TEST(TrimmedPatch, refuses_loops_that_do_not_fit) {
    const NurbsSurface surface = square(2);
    const auto circle = circleLoop(LoopKind::outer, {0.5, 0.5}, 0.4);
    expectInputError(
        [&] {
            TrimmedPatch(surface, {circleLoop(LoopKind::inner, {0.9, 0.5}, 0.2)}, "wing");
        },
        {"wing", "outside", "0 to 1"});
    expectInputError(
        [&] {
            TrimmedPatch(surface, {circle, circleLoop(LoopKind::inner, {0.8, 0.5}, 0.15)});
        },
        {"loops 0 and 1 cross or touch"});
    expectInputError(
        [&] {
            TrimmedPatch(surface, {circle, circleLoop(LoopKind::inner, {0.95, 0.95}, 0.03)});
        },
        {"inner trimming loop 1 lies outside"});
    expectInputError(
        [&] {
            TrimmedPatch(surface, {circle, circleLoop(LoopKind::outer, {0.5, 0.5}, 0.2)});
        },
        {"outer trimming loop", "inside another"});
}

} // namespace tokay::geometry
