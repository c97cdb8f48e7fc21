// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/Tile.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"

#include <algorithm>

namespace tokay::geometry {

namespace {

/// Parts of an element this thin hold nothing but rounding.
constexpr double thinnest = 1e-15;

/// A side of the element's cut, rising, with how the winding number changes
/// from its left to its right.
struct Crossing {
    PlaneBezier rising;
    int change;
};

PlaneBezier clampedInto(const ParameterBox& box, const PlaneBezier& side) {
    const auto clamped = [&](const Parameters& point) {
        return Parameters(point.cwiseMax(box.lower).cwiseMin(box.upper));
    };
    return side.withEnds(clamped(side.start()), clamped(side.end()));
}

std::vector<Crossing> crossings(const ParameterBox& box, const std::vector<PlaneBezier>& sides) {
    std::vector<Crossing> result;
    for (const PlaneBezier& side : sides) {
        const PlaneBezier inside = clampedInto(box, side);
        // The region lies to the left of a side that rises.
        if (inside.start()[1] < inside.end()[1]) {
            result.push_back({inside, -1});
        } else if (inside.start()[1] > inside.end()[1]) {
            result.push_back({inside.reversed(), 1});
        }
    }
    return result;
}

std::vector<double> heights(const ParameterBox& box, const std::vector<Crossing>& crossings,
                            const std::vector<WindingStep>& leftWinding) {
    std::vector<double> all = {box.lower[1], box.upper[1]};
    for (const Crossing& crossing : crossings) {
        for (const Parameters& end : {crossing.rising.start(), crossing.rising.end()}) {
            all.push_back(end[1]);
        }
    }
    for (const WindingStep& step : leftWinding) {
        all.push_back(std::clamp(step.eta, box.lower[1], box.upper[1]));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

void appendTiles(const ParameterBox& box, double from, double to, int winding,
                 const std::vector<Crossing>& crossings, std::vector<Tile>& tiles) {
    struct Met {
        double xi;
        const Crossing* crossing;
    };
    std::vector<Met> met;
    const double middle = 0.5 * (from + to);
    for (const Crossing& crossing : crossings) {
        if (crossing.rising.start()[1] <= from && crossing.rising.end()[1] >= to) {
            met.push_back({TileSide::curved(crossing.rising).xiAt(middle), &crossing});
        }
    }
    std::sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.xi < b.xi; });

    TileSide left = TileSide::straight(box.lower[0]);
    const auto close = [&](TileSide right) {
        Tile tile{from, to, left, std::move(right)};
        if (tile.area() > thinnest * box.area()) {
            tiles.push_back(std::move(tile));
        }
    };
    for (const auto& [xi, crossing] : met) {
        const TileSide side = TileSide::curved(crossing->rising).part(from, to);
        if (winding > 0) {
            close(side);
        }
        winding += crossing->change;
        left = side;
    }
    if (winding > 0) {
        close(TileSide::straight(box.upper[0]));
    }
}

} // namespace

TileSide TileSide::part(double etaFrom, double etaTo) const {
    if (!curve) {
        return *this;
    }
    PlaneBezier remainder = *curve;
    if (remainder.end()[1] != etaTo) {
        remainder = remainder.split(remainder.parameterAt(1, etaTo))[0];
    }
    if (remainder.start()[1] != etaFrom) {
        remainder = remainder.split(remainder.parameterAt(1, etaFrom))[1];
    }
    return curved(remainder.withEnds({remainder.start()[0], etaFrom}, {remainder.end()[0], etaTo}));
}

double TileSide::integral(double height) const {
    if (!curve) {
        return xi * height;
    }
    const QuadratureRule& rule = gaussLegendre(12);
    // Seen from an end, so that thin tiles keep their digits.
    const double origin = curve->start()[0];
    double sum = origin * height;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
        const auto [point, derivative] = curve->tangent(rule.points[k]);
        sum += rule.weights[k] * (point[0] - origin) * derivative[1];
    }
    return sum;
}

Polygon Tile::polygon(const Parameters& chordTolerance) const {
    Polygon polygon;
    const auto append = [&](const TileSide& side, bool rises) {
        const Parameters bottom(side.xiAtBottom(), etaFrom), top(side.xiAtTop(), etaTo);
        if (side.curve) {
            (rises ? *side.curve : side.curve->reversed()).appendChords(chordTolerance, polygon);
        } else {
            polygon.push_back(rises ? bottom : top);
        }
        polygon.push_back(rises ? top : bottom);
    };
    append(right, true);
    append(left, false);
    return polygon;
}

std::vector<Tile> elementTiles(const ParameterBox& element, const std::vector<PlaneBezier>& sides,
                               const std::vector<WindingStep>& leftWinding) {
    const std::vector<Crossing> met = crossings(element, sides);
    const std::vector<double> levels = heights(element, met, leftWinding);
    std::vector<Tile> tiles;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        if (levels[i + 1] - levels[i] <= thinnest * element.size()[1]) {
            continue;
        }
        int winding = 0;
        for (const WindingStep& step : leftWinding) {
            if (step.eta <= levels[i]) {
                winding += step.change;
            }
        }
        appendTiles(element, levels[i], levels[i + 1], winding, met, tiles);
    }
    return tiles;
}

} // namespace tokay::geometry
