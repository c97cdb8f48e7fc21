// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/gaussLegendre.hpp"
#include "mapper/loads/LoadPointList.hpp"

#include <algorithm>

namespace tokay::mapper {

namespace {

struct KnotPlane {
    Point position, tangent;
};

std::vector<KnotPlane> knotPlanes(const CurveInterface& splines) {
    std::vector<KnotPlane> planes;
    for (int i = 0; i < splines.nCurves(); ++i) {
        for (const double xi : splines.curve(i).breakpoints()) {
            const Points d = splines.curve(i).derivatives(xi, 1);
            planes.push_back({d.row(0), d.row(1)});
        }
    }
    return planes;
}

int gaussPointsOf(const CurveInterface& splines) {
    int degree = 0;
    for (int i = 0; i < splines.nCurves(); ++i) {
        degree = std::max(degree, splines.curve(i).degree());
    }
    return degree / 2 + 2; // one more than a straight curve needs
}

// Ends of the pieces of an edge, from 0 to 1. Planes of knots farther away than the
// curve can be from the edge belong to other parts of it.
std::vector<double> pieceEnds(const Point& a, const Point& b, double gap,
                              const std::vector<KnotPlane>& planes) {
    constexpr double least = 1e-9; // of the edge: a piece that rounding makes
    const Point chord = b - a;
    const double reach = 2 * gap + chord.norm();
    std::vector<double> ends = {0};
    for (const KnotPlane& plane : planes) {
        const double slope = chord.dot(plane.tangent);
        const double s = (plane.position - a).dot(plane.tangent) / slope;
        if (s > least && s < 1 - least && (a + s * chord - plane.position).norm() <= reach) {
            ends.push_back(s);
        }
    }
    ends.push_back(1);
    std::sort(ends.begin(), ends.end());
    const auto isNext = [](double first, double second) { return second - first < least; };
    ends.erase(std::unique(ends.begin(), ends.end(), isNext), ends.end());
    return ends;
}

} // namespace

LoadPoints integratedLoads(const CurveInterface& splines, const FaceMesh& mesh) {
    const std::vector<KnotPlane> planes = knotPlanes(splines);
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(gaussPointsOf(splines));
    LoadPointList list;
    for (int face = 0; face < mesh.nFaces(); ++face) {
        const Point a = mesh.vertices.row(mesh.faces[face].front());
        const Point b = mesh.vertices.row(mesh.faces[face].back());
        const double gap = splines.closest(0.5 * (a + b)).onCurve.distance;
        const std::vector<double> ends = pieceEnds(a, b, gap, planes);
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            const double length = ends[k + 1] - ends[k];
            for (std::size_t q = 0; q < rule.points.size(); ++q) {
                const double s = ends[k] + length * rule.points[q];
                list.add(a + s * (b - a), face, rule.weights[q] * length);
            }
        }
    }
    return list.finish(mesh.nFaces());
}

} // namespace tokay::mapper
