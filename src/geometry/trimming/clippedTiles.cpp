// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/clippedTiles.hpp"

#include "geometry/bezier/parameterCrossings.hpp"
#include "geometry/trimming/tileRule.hpp"

#include <algorithm>

namespace tokay::geometry {

namespace {

/// A side of the polygon that is not horizontal, rising.
struct Side {
    Parameters low, high;

    double xiAt(double eta) const {
        const double share = (eta - low[1]) / (high[1] - low[1]);
        return low[0] + share * (high[0] - low[0]);
    }
    TileSide part(double from, double to) const {
        PlaneBezier::Controls controls(3, 2);
        controls << xiAt(from), xiAt(to), from, to, 1, 1;
        return TileSide::curved(PlaneBezier(controls));
    }
};

struct Sides {
    std::vector<Side> left, right;
};

Sides sidesOf(const Polygon& convex) {
    Sides sides;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Parameters &a = convex[i], &b = convex[(i + 1) % convex.size()];
        if (a[1] < b[1]) {
            sides.right.push_back({a, b});
        } else if (a[1] > b[1]) {
            sides.left.push_back({b, a});
        }
    }
    return sides;
}

/// Heights at which a side of a tile passes through the line of a polygon's.
void appendCrossings(const TileSide& tileSide, const Side& side, std::vector<double>& heights) {
    const Parameters along = side.high - side.low;
    if (!tileSide.curve) {
        if (along[0] != 0) {
            heights.push_back(side.low[1] + (tileSide.xi - side.low[0]) / along[0] * along[1]);
        }
        return;
    }
    const PlaneBezier& curve = *tileSide.curve;
    Points distances = Points::Zero(curve.degree() + 1, 3);
    for (int i = 0; i <= curve.degree(); ++i) {
        const Parameters arm = curve.controlPoint(i) - side.low;
        distances(i, 0) = curve.weight(i) * (along[0] * arm[1] - along[1] * arm[0]);
    }
    if ((distances.col(0).array() > 0).all() || (distances.col(0).array() < 0).all()) {
        return;
    }
    const NurbsCurve distance(KnotVector::uniform(curve.degree(), 1), std::move(distances));
    for (const double t : parameterCrossings(distance, 0, 0.0)) {
        heights.push_back(curve.point(t)[1]);
    }
}

std::vector<double> heights(const Tile& tile, const Polygon& convex, const Sides& sides) {
    double low = convex[0][1], high = low;
    std::vector<double> all;
    for (const Parameters& corner : convex) {
        low = std::min(low, corner[1]);
        high = std::max(high, corner[1]);
        all.push_back(corner[1]);
    }
    low = std::max(low, tile.etaFrom);
    high = std::min(high, tile.etaTo);
    if (!(low < high)) {
        return {};
    }
    for (const auto* group : {&sides.left, &sides.right}) {
        for (const Side& side : *group) {
            appendCrossings(tile.left, side, all);
            appendCrossings(tile.right, side, all);
        }
    }
    all.insert(all.end(), {low, high});
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](double eta) { return !(eta >= low && eta <= high); }),
              all.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

const Side* sideAt(const std::vector<Side>& sides, double eta) {
    for (const Side& side : sides) {
        if (side.low[1] <= eta && eta <= side.high[1]) {
            return &side;
        }
    }
    return nullptr;
}

} // namespace

void appendClipped(const Tile& tile, const Polygon& convex, std::vector<Tile>& parts) {
    const Sides sides = sidesOf(convex);
    const std::vector<double> levels = heights(tile, convex, sides);
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        const double from = levels[i], to = levels[i + 1], middle = 0.5 * (from + to);
        const Side *left = sideAt(sides.left, middle), *right = sideAt(sides.right, middle);
        if (!left || !right || middle <= from || middle >= to) {
            continue;
        }
        const double tileLeft = tile.left.xiAt(middle), tileRight = tile.right.xiAt(middle);
        const double cellLeft = left->xiAt(middle), cellRight = right->xiAt(middle);
        if (std::max(tileLeft, cellLeft) >= std::min(tileRight, cellRight)) {
            continue;
        }
        parts.push_back(
            {from, to, tileLeft >= cellLeft ? tile.left.part(from, to) : left->part(from, to),
             tileRight <= cellRight ? tile.right.part(from, to) : right->part(from, to)});
    }
}

std::vector<Tile> clippedTiles(const TrimmedPatch& patch, const Polygon& cell) {
    Parameters centre = Parameters::Zero();
    for (const Parameters& corner : cell) {
        centre += corner / static_cast<double>(cell.size());
    }
    std::vector<Tile> parts;
    for (const Tile& tile : patch.tiles(patch.elementAt(centre))) {
        appendClipped(tile, cell, parts);
    }
    return parts;
}

std::vector<ParameterPoint> tileQuadrature(const std::vector<Tile>& tiles, int degree) {
    std::vector<ParameterPoint> points;
    for (const Tile& tile : tiles) {
        appendTileRule(tile, degree, 0, points);
    }
    return points;
}

} // namespace tokay::geometry
