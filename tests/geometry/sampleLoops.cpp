// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampleLoops.hpp"

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/refinement.hpp"

#include <cmath>

namespace tokay::geometry {

TrimmingLoop circleLoop(LoopKind kind, const Parameters& centre, double radius) {
    const NurbsCurve circle =
        arc(Point(centre[0], centre[1], 0), radius, 0.3, 0.3 + 2 * std::acos(-1.0));
    return TrimmingLoop(kind, {kind == LoopKind::outer ? circle : reversed(circle)});
}

TrimmingLoop polygonLoop(LoopKind kind, const Polygon& corners) {
    std::vector<NurbsCurve> sides;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Parameters &a = corners[i], &b = corners[(i + 1) % corners.size()];
        sides.push_back(line(Point(a[0], a[1], 0), Point(b[0], b[1], 0)));
    }
    return TrimmingLoop(kind, std::move(sides));
}

NurbsSurface square(int nSpans, double size) {
    Points corners(4, 3);
    corners << 0, 0, 0, size, 0, 0, 0, size, 0, size, size, 0;
    const KnotVector range = KnotVector::uniform(1, 1, 0, size);
    return refine(NurbsSurface(range, range, corners), 2, 2, nSpans, nSpans);
}

} // namespace tokay::geometry
