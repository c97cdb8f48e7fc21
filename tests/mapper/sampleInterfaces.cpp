// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampleInterfaces.hpp"

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"

#include <cmath>
#include <numeric>

namespace tokay::mapper {

namespace {

geometry::NurbsSurface flap() {
    return refine(geometry::rectangle(Point(-0.05, 0, 0), 0.1, 1), 2, 2, 2, 12);
}

std::vector<int> consecutive(int n) {
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

SplineInterface wholeCurve(const geometry::NurbsCurve& curve) {
    const int n = curve.nControlPoints();
    return SplineInterface({{curve, consecutive(n), "curve"}}, n);
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

namespace {

CurveInterface verticalLine(int nElements, double x, ValuesAt valuesAt) {
    Points vertices(nElements + 1, 3);
    std::vector<std::array<int, 2>> elements;
    for (int i = 0; i <= nElements; ++i) {
        const double t = static_cast<double>(i) / nElements;
        vertices.row(i) << x, t + 0.3 * t * (1 - t), 0;
        if (i > 0) {
            elements.push_back({i - 1, i});
        }
    }
    return lineMesh(vertices, elements, valuesAt);
}

} // namespace

CurveInterface verticalMesh(int nElements, double x) {
    return verticalLine(nElements, x, ValuesAt::vertices);
}

CurveInterface verticalFaces(int nElements, double x) {
    return verticalLine(nElements, x, ValuesAt::faces);
}

SplineInterface verticalSpline(int degree, int nSpans, double x) {
    return wholeCurve(refine(geometry::line(Point(x, 0, 0), Point(x, 1, 0)), degree, nSpans));
}

CurveInterface trimmedEdge(double xi) {
    const double width = 2;
    const geometry::NurbsSurface surface =
        refine(geometry::rectangle(Point(-xi * width, 0, 0), width, 1), 2, 2, 2, 2);
    std::vector<std::unique_ptr<InterfaceCurve>> curves;
    curves.push_back(interfaceCurve(
        geometry::CurveOnSurface(geometry::line(Point(xi, 0, 0), Point(xi, 1, 0)), surface),
        consecutive(surface.nControlPoints())));
    return CurveInterface(std::move(curves), surface.controlPoints());
}

SplineInterface quarterCircle(int degree, int nSpans) {
    return wholeCurve(refine(geometry::arc(Point::Zero(), 1, 0, std::acos(0.0)), degree, nSpans));
}

} // namespace tokay::mapper
