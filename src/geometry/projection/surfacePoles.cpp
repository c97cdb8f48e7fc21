// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/surfacePoles.hpp"

#include "geometry/projection/BoxTree.hpp"

#include <Eigen/Geometry>

namespace tokay::geometry {

namespace {

/// Tangents across the edge, at places along it.
Points tangentsAcross(const NurbsSurface& surface, Edge edge) {
    const bool alongU = edge == Edge::bottom || edge == Edge::top;
    const bool isFirst = edge == Edge::bottom || edge == Edge::left;
    const KnotVector &along = alongU ? surface.u() : surface.v(),
                     &across = alongU ? surface.v() : surface.u();
    constexpr int n = 9;
    Points tangents(n, 3);
    for (int i = 0; i < n; ++i) {
        const double t = along.first() + (along.last() - along.first()) * i / (n - 1);
        const double end = isFirst ? across.first() : across.last();
        tangents.row(i) =
            surface.derivatives(alongU ? t : end, alongU ? end : t, 1).row(alongU ? 2 : 1);
    }
    return tangents;
}

/// The tangents of a smooth pole lie in one plane.
Point normalOf(const Points& tangents) {
    Point normal = Point::Zero();
    for (Eigen::Index i = 1; i < tangents.rows(); ++i) {
        const Point candidate = Point(tangents.row(0)).cross(Point(tangents.row(i)));
        if (candidate.norm() > normal.norm()) {
            normal = candidate;
        }
    }
    const double longest = tangents.rowwise().norm().maxCoeff();
    if (!(normal.norm() > 1e-9 * longest * longest)) {
        return Point::Zero();
    }
    normal.normalize();
    const bool isPlane = (tangents * normal).cwiseAbs().maxCoeff() < 1e-9 * longest;
    return isPlane ? normal : Point::Zero();
}

} // namespace

std::vector<Pole> surfacePoles(const NurbsSurface& surface) {
    const double size = Box::around(surface.controlPoints()).diagonal();
    std::vector<Pole> poles;
    for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
        const Points points = surface.boundaryCurve(edge).curve.controlPoints();
        if (Box::around(points).diagonal() < 1e-12 * size) {
            poles.push_back({edge, points.row(0), normalOf(tangentsAcross(surface, edge))});
        }
    }
    return poles;
}

} // namespace tokay::geometry
