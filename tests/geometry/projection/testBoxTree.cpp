// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/BoxTree.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

std::vector<Box> scatteredBoxes(int n) {
    std::vector<Box> boxes;
    for (int i = 0; i < n; ++i) {
        const Point corner(std::sin(1.0 * i), std::sin(2.1 * i), std::cos(1.7 * i));
        boxes.push_back({corner, corner + 0.1 * Point(1 + std::sin(i), 1 + std::cos(i), 1)});
    }
    return boxes;
}

} // namespace

TEST(BoxTree, visits_every_box_from_near_to_far) {
    const std::vector<Box> boxes = scatteredBoxes(200);
    const Point point(0.2, -0.3, 0.1);
    double last = 0;
    int visited = 0;
    BoxTree(boxes).visitNearest(point, [&](int box) {
        const double distance = boxes[box].squaredDistance(point);
        EXPECT_GE(distance, last);
        last = distance;
        ++visited;
        return 1e300;
    });
    EXPECT_EQ(visited, 200);
}

TEST(BoxTree, stops_at_the_distance_that_the_visitor_gives) {
    const std::vector<Box> boxes = scatteredBoxes(200);
    const Point point(0.2, -0.3, 0.1);
    int expected = 0, visited = 0;
    for (const Box& box : boxes) {
        expected += box.squaredDistance(point) <= 0.25;
    }
    BoxTree(boxes).visitNearest(point, [&](int) { return ++visited, 0.25; });
    EXPECT_EQ(visited, expected);
}

TEST(BoxTree, finds_exactly_the_overlapping_boxes) {
    const std::vector<Box> boxes = scatteredBoxes(300);
    const Box window{Point(-0.5, -0.5, -0.5), Point(0.4, 0.3, 0.6)};
    std::vector<int> expected;
    for (int i = 0; i < 300; ++i) {
        if (boxes[i].overlaps(window)) {
            expected.push_back(i);
        }
    }
    EXPECT_GT(expected.size(), 10u);
    EXPECT_EQ(BoxTree(boxes).overlapping(window), expected);
}

TEST(BoxTree, finds_exactly_the_boxes_that_meet_a_half_space) {
    const std::vector<Box> boxes = scatteredBoxes(300);
    const Point normal(0.6, -0.48, 0.64);
    const auto meets = [&](const Box& box) {
        return normal.dot(box.centre()) + 0.5 * normal.cwiseAbs().dot(box.upper - box.lower) >= 0.9;
    };
    std::vector<int> expected;
    for (int i = 0; i < 300; ++i) {
        if (meets(boxes[i])) {
            expected.push_back(i);
        }
    }
    EXPECT_GT(expected.size(), 10u);
    EXPECT_LT(expected.size(), 100u);
    EXPECT_EQ(BoxTree(boxes).meeting(meets), expected);
}

} // namespace tokay::geometry
