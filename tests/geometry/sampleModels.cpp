// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampleModels.hpp"

#include "geometry/primitives/primitives.hpp"
#include "sampleLoops.hpp"

#include <cmath>

namespace tokay::geometry {

BrepModel twoSquares(double gap) {
    const TrimmedPatch left(
        rectangle(Point::Zero(), 1, 1),
        {TrimmingLoop::around({{0, 0}, {1, 1}}), circleLoop(LoopKind::inner, {0.5, 0.5}, 0.25)},
        "left");
    const TrimmedPatch right(rectangle(Point(1, 0, gap), 1, 1), "right");
    const std::vector<BrepFace> faces = {{left}, {right}};
    return BrepModel(faces, coincidentEdges(faces, 1.1 * gap + 1e-9), 1e-6);
}

BrepModel halfCylinders() {
    const double pi = std::acos(-1.0);
    const std::vector<BrepFace> faces = {
        {TrimmedPatch(cylinderPatch(Point::Zero(), 1, 2, 0, pi), "front")},
        {TrimmedPatch(cylinderPatch(Point::Zero(), 1, 2, pi, 2 * pi), "back")}};
    return BrepModel(faces, coincidentEdges(faces, 1e-9));
}

double largestGap(const BrepModel& model, const BrepEdge& edge) {
    double largest = 0;
    const CurveOnSurface first = model.curveInSpace(edge.trims[0]);
    const double start = first.breakpoints().front();
    const double end = first.breakpoints().back();
    for (const BrepTrim& trim : edge.trims) {
        const CurveOnSurface other = model.curveInSpace(trim);
        for (const double part : {0.0, 0.2, 0.5, 0.8, 1.0}) {
            const Point point = first.derivatives(start + part * (end - start), 0).row(0);
            largest = std::max(largest, other.closest(point).distance);
        }
    }
    return largest;
}

} // namespace tokay::geometry
