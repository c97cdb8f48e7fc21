#include "sampleInterfaces.hpp"

#include "geometry/primitives.hpp"
#include "geometry/refinement.hpp"
#include <cmath>

namespace tokay::mapper {

namespace {

geometry::NurbsSurface flap() {
    return refine(geometry::rectangle(Point(-0.05, 0, 0), 0.1, 1), 2, 2, 2, 12);
}

} // namespace

SplineInterface flapInterface() {
    const geometry::NurbsSurface surface = flap();
    std::vector<SplinePiece> pieces;
    for (const char* edge : {"left", "top", "right"}) {
        const auto boundary = surface.boundaryCurve(geometry::edgeFromName(edge));
        pieces.push_back({boundary.curve, boundary.controlPoints, edge});
    }
    return SplineInterface(pieces, surface.nControlPoints());
}

int nFlapControlPoints() {
    return flap().nControlPoints();
}

Points flapPoints(int nPerEdge) {
    Points points(3 * nPerEdge, 3);
    for (int i = 0; i < nPerEdge; ++i) {
        const double t = static_cast<double>(i) / (nPerEdge - 1);
        points.row(i) << -0.05, t, 0;
        points.row(nPerEdge + i) << -0.05 + 0.1 * t, 1, 0;
        points.row(2 * nPerEdge + i) << 0.05, 1 - t, 0;
    }
    return points;
}

SplineInterface quarterCircle(int degree, int nSpans) {
    const geometry::NurbsCurve curve =
        refine(geometry::arc(Point::Zero(), 1, 0, std::acos(0.0)), degree, nSpans);
    std::vector<int> numbers(curve.nControlPoints());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<int>(i);
    return SplineInterface({{curve, numbers, "arc"}}, curve.nControlPoints());
}

} // namespace tokay::mapper
