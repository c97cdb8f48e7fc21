// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/ShellNodes.hpp"

#include <algorithm>
#include <numeric>

namespace tokay::structure {

namespace {

// For each control point the first one at a pole, or itself.
std::vector<int> representatives(const geometry::NurbsSurface& surface, double size) {
    constexpr double poleTolerance = 1e-10; // of the model's size
    std::vector<int> first(surface.nControlPoints());
    std::iota(first.begin(), first.end(), 0);
    for (geometry::Edge edge : {geometry::Edge::left, geometry::Edge::right, geometry::Edge::bottom,
                                geometry::Edge::top}) {
        const geometry::BoundaryCurve rim = surface.boundaryCurve(edge);
        const geometry::Points& points = rim.curve.controlPoints();
        const double extent = (points.rowwise() - points.row(0)).rowwise().norm().maxCoeff();
        if (extent <= poleTolerance * size) {
            for (int k : rim.controlPoints) {
                first[k] = std::min(first[k], first[rim.controlPoints[0]]);
            }
        }
    }
    return first;
}

} // namespace

ShellNodes::ShellNodes(const geometry::BrepModel& model) {
    std::vector<geometry::Point> places;
    for (const geometry::BrepFace& face : model.faces()) {
        const geometry::NurbsSurface& surface = face.patch.basis();
        const std::vector<int> first = representatives(surface, model.size());
        std::vector<int> numbers(first.size());
        for (std::size_t k = 0; k < first.size(); ++k) {
            if (first[k] == static_cast<int>(k)) {
                numbers[k] = static_cast<int>(places.size());
                places.emplace_back(surface.controlPoints().row(static_cast<Eigen::Index>(k)));
            } else {
                numbers[k] = numbers[first[k]];
            }
        }
        ofFace.push_back(std::move(numbers));
    }
    positions.resize(static_cast<Eigen::Index>(places.size()), 3);
    for (std::size_t k = 0; k < places.size(); ++k) {
        positions.row(static_cast<Eigen::Index>(k)) = places[k].transpose();
    }
}

} // namespace tokay::structure
