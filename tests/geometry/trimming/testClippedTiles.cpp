// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/clippedTiles.hpp"
#include "sampleLoops.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

const double pi = std::acos(-1.0);

/// Uneven triangles that cover the unit square.
std::vector<Polygon> triangles(int n) {
    const auto corner = [&](int i, int j) {
        const double x = i + (i == 0 || i == n ? 0 : 0.3 * std::sin(3.0 * i + j));
        const double y = j + (j == 0 || j == n ? 0 : 0.3 * std::cos(2.0 * i - j));
        return Parameters(x / n, y / n);
    };
    std::vector<Polygon> cells;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            cells.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
            cells.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    }
    return cells;
}

struct Sums {
    double area = 0, moment = 0;
};

Sums overCells(const TrimmedPatch& patch, const std::vector<Polygon>& cells) {
    Sums sums;
    for (const Polygon& cell : cells) {
        for (const ParameterPoint& point : tileQuadrature(clippedTiles(patch, cell), 2)) {
            EXPECT_GT(point.weight, 0);
            EXPECT_TRUE(patch.contains({point.xi, point.eta}));
            sums.area += point.weight;
            sums.moment += point.weight * point.xi * point.xi;
        }
    }
    return sums;
}

} // namespace

TEST(ClippedTiles, cellsThatCoverAPatchIntegrateItExactly) {
    const TrimmedPatch patch(square(1), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.45),
                                         circleLoop(LoopKind::inner, {0.55, 0.45}, 0.15)});
    const double moment = pi / 4 * (std::pow(0.45, 4) - std::pow(0.15, 4)) +
                          pi * (0.45 * 0.45 * 0.25 - 0.15 * 0.15 * 0.55 * 0.55);
    for (const int n : {1, 3, 8, 21}) {
        const Sums sums = overCells(patch, triangles(n));
        EXPECT_NEAR(sums.area, pi * (0.45 * 0.45 - 0.15 * 0.15), 1e-13) << n;
        EXPECT_NEAR(sums.moment, moment, 1e-13) << n;
    }
}

TEST(ClippedTiles, sidesOnTheTrimLineAndBesideItAreExact) {
    const TrimmedPatch patch(square(1),
                             {polygonLoop(LoopKind::outer, {{0, 0}, {0.4, 0}, {0.6, 1}, {0, 1}})});
    // Cells that meet on the trim line, or a little beside it.
    for (const double offset : {0.0, 1e-16, 1e-12, -1e-12, 1e-8, -1e-4}) {
        const Polygon left = {{0, 0}, {0.4 + offset, 0}, {0.6 + offset, 1}, {0, 1}};
        const Polygon right = {{0.4 + offset, 0}, {1, 0}, {1, 1}, {0.6 + offset, 1}};
        EXPECT_NEAR(overCells(patch, {left}).area, 0.5 + std::min(offset, 0.0), 1e-15) << offset;
        EXPECT_NEAR(overCells(patch, {left, right}).area, 0.5, 1e-15) << offset;
    }
}

TEST(ClippedTiles, aCellOutsideTheLoopsHasNone) {
    const TrimmedPatch patch(square(1), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.4)});
    EXPECT_TRUE(clippedTiles(patch, {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}}).empty());
    EXPECT_TRUE(clippedTiles(patch, {{0.3, 0}, {0.7, 0}, {0.5, 0.05}}).empty());
}

} // namespace tokay::geometry
