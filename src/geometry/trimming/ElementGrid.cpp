// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/ElementGrid.hpp"

#include <algorithm>
#include <map>

namespace tokay::geometry {

namespace {

struct Cut {
    double t;
    int axis;
    double value;
};

/// Where a monotone piece passes through lines.
void appendCuts(const PlaneBezier& piece, int axis, const std::vector<double>& lines,
                std::vector<Cut>& cuts) {
    const auto [low, high] = std::minmax(piece.start()[axis], piece.end()[axis]);
    for (auto line = std::upper_bound(lines.begin(), lines.end(), low);
         line != lines.end() && *line < high; ++line) {
        cuts.push_back({piece.parameterAt(axis, *line), axis, *line});
    }
}

PlaneBezier part(const PlaneBezier& piece, double from, double to) {
    const PlaneBezier head = to < 1 ? piece.split(to)[0] : piece;
    return from > 0 ? head.split(std::min(1.0, from / to))[1] : head;
}

int intervalAt(const std::vector<double>& lines, double value) {
    const auto after = std::upper_bound(lines.begin(), lines.end(), value);
    return std::clamp(static_cast<int>(after - lines.begin()) - 1, 0,
                      static_cast<int>(lines.size()) - 2);
}

} // namespace

ElementGrid::ElementGrid(std::vector<double> xi, std::vector<double> eta)
    : xi_(std::move(xi)), eta_(std::move(eta)) {}

ParameterBox ElementGrid::box(int element) const {
    const int i = element % nU(), j = element / nU();
    return {{xi_[i], eta_[j]}, {xi_[i + 1], eta_[j + 1]}};
}

ParameterBox ElementGrid::box() const {
    return {{xi_.front(), eta_.front()}, {xi_.back(), eta_.back()}};
}

int ElementGrid::elementAt(const Parameters& point) const {
    return intervalAt(xi_, point[0]) + nU() * intervalAt(eta_, point[1]);
}

std::vector<std::vector<PlaneBezier>>
ElementGrid::cut(const std::vector<PlaneBezier>& pieces) const {
    std::vector<std::vector<PlaneBezier>> sides(nElements());
    const auto keep = [&](const PlaneBezier& side) {
        sides[elementAt(0.5 * (side.start() + side.end()))].push_back(side);
    };
    for (const PlaneBezier& piece : pieces) {
        std::vector<Cut> cuts;
        appendCuts(piece, 0, xi_, cuts);
        appendCuts(piece, 1, eta_, cuts);
        std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.t < b.t; });
        double from = 0;
        Parameters start = piece.start();
        for (const Cut& cut : cuts) {
            Parameters joint = piece.point(cut.t);
            joint[cut.axis] = cut.value;
            keep(part(piece, from, cut.t).withEnds(start, joint));
            from = cut.t;
            start = joint;
        }
        keep(part(piece, from, 1).withEnds(start, piece.end()));
    }
    return sides;
}

std::vector<std::vector<WindingStep>>
ElementGrid::leftWindings(const std::vector<std::vector<PlaneBezier>>& sides) const {
    std::vector<std::vector<WindingStep>> windings(nElements());
    for (int j = 0; j < nV(); ++j) {
        std::map<double, int> changes;
        const auto add = [&](double eta, int change) {
            int& sum = changes[std::clamp(eta, eta_[j], eta_[j + 1])];
            sum += change;
            if (sum == 0) {
                changes.erase(std::clamp(eta, eta_[j], eta_[j + 1]));
            }
        };
        for (int i = 0; i < nU(); ++i) {
            const int element = i + nU() * j;
            for (const auto& [eta, change] : changes) {
                windings[element].push_back({eta, change});
            }
            for (const PlaneBezier& side : sides[element]) {
                // Right of a falling side lies the region, between its heights.
                add(side.start()[1], -1);
                add(side.end()[1], 1);
            }
        }
    }
    return windings;
}

} // namespace tokay::geometry
