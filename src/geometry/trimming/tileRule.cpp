// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/tileRule.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"

#include <algorithm>

namespace tokay::geometry {

namespace {

/// Straight line from the bottom of a tile to its top.
struct Line {
    double etaFrom, xiFrom, slope;

    double xiAt(double eta) const { return xiFrom + slope * (eta - etaFrom); }
};

struct Rule {
    int degree, nAlong;
    std::vector<ParameterPoint>& points;

    int nAcross() const { return degree / 2 + 1; }
    int nAlongSide(const PlaneBezier& side) const;
    void append(const Parameters& point, double weight) const {
        if (weight > 0) {
            points.push_back({point[0], point[1], weight});
        }
    }
};

bool isRational(const PlaneBezier& side) {
    for (int i = 1; i <= side.degree(); ++i) {
        if (side.weight(i) != side.weight(0)) {
            return true;
        }
    }
    return false;
}

int Rule::nAlongSide(const PlaneBezier& side) const {
    if (nAlong > 0) {
        return nAlong;
    }
    // In t: xi^degree integrated across and eta^degree, times the slope of eta.
    const int along = side.degree() * (2 * degree + 2) - 1;
    return along / 2 + 1 + (isRational(side) ? 2 : 0);
}

/// Between a straight line and a side.
void appendOneSided(const Line& line, const PlaneBezier& side, const Rule& rule) {
    const QuadratureRule& along = gaussLegendre(rule.nAlongSide(side));
    const QuadratureRule& across = gaussLegendre(rule.nAcross());
    for (std::size_t k = 0; k < along.points.size(); ++k) {
        const auto [place, derivative] = side.tangent(along.points[k]);
        const double base = line.xiAt(place[1]), width = place[0] - base;
        const double weight = along.weights[k] * derivative[1] * std::abs(width);
        for (std::size_t l = 0; l < across.points.size(); ++l) {
            rule.append({base + across.points[l] * width, place[1]}, weight * across.weights[l]);
        }
    }
}

/// Appends points by height: right for any sides, but no better than they are smooth in eta.
void appendByHeight(const Tile& tile, const Rule& rule) {
    const QuadratureRule& along = gaussLegendre(rule.nAcross());
    for (std::size_t k = 0; k < along.points.size(); ++k) {
        const double eta = tile.etaFrom + along.points[k] * tile.height();
        const double left = tile.left.xiAt(eta), width = tile.right.xiAt(eta) - left;
        for (std::size_t l = 0; l < along.points.size(); ++l) {
            rule.append({left + along.points[l] * width, eta},
                        along.weights[k] * along.weights[l] * width * tile.height());
        }
    }
}

/// True if all of a side lies on one side of a line (sign 1: right of it).
bool liesBeside(const PlaneBezier& side, const Line& line, double sign) {
    for (int i = 0; i <= side.degree(); ++i) {
        const Parameters point = side.controlPoint(i);
        if (sign * (point[0] - line.xiAt(point[1])) < 0) {
            return false;
        }
    }
    return true;
}

void appendTwoSided(const Tile& tile, const Rule& rule, int depth) {
    const double bottom = 0.5 * (tile.left.xiAtBottom() + tile.right.xiAtBottom());
    const double top = 0.5 * (tile.left.xiAtTop() + tile.right.xiAtTop());
    const Line line{tile.etaFrom, bottom, (top - bottom) / tile.height()};
    if (liesBeside(*tile.left.curve, line, -1) && liesBeside(*tile.right.curve, line, 1)) {
        appendOneSided(line, *tile.left.curve, rule);
        appendOneSided(line, *tile.right.curve, rule);
        return;
    }
    constexpr int deepest = 24; // into a cusp
    const double middle = 0.5 * (tile.etaFrom + tile.etaTo);
    if (depth == deepest || middle <= tile.etaFrom || middle >= tile.etaTo) {
        appendByHeight(tile, rule);
        return;
    }
    for (const auto& [from, to] :
         {std::pair(tile.etaFrom, middle), std::pair(middle, tile.etaTo)}) {
        appendTwoSided({from, to, tile.left.part(from, to), tile.right.part(from, to)}, rule,
                       depth + 1);
    }
}

} // namespace

void appendTileRule(const Tile& tile, int degree, int nAlong, std::vector<ParameterPoint>& points) {
    const Rule rule{degree, nAlong, points};
    if (tile.isRectangle()) {
        appendByHeight(tile, rule);
    } else if (!tile.left.curve) {
        appendOneSided({tile.etaFrom, tile.left.xi, 0}, *tile.right.curve, rule);
    } else if (!tile.right.curve) {
        appendOneSided({tile.etaFrom, tile.right.xi, 0}, *tile.left.curve, rule);
    } else {
        appendTwoSided(tile, rule, 0);
    }
}

} // namespace tokay::geometry
