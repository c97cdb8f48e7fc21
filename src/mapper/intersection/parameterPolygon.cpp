// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/parameterPolygon.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace tokay::mapper {

using geometry::KnotVector;
using geometry::NurbsSurface;
using geometry::Point;
using geometry::Points;
using geometry::Polygon;
using geometry::signedArea;

namespace {

const KnotVector& direction(const NurbsSurface& surface, int axis) {
    return axis == 0 ? surface.u() : surface.v();
}

/// The step along the tangents that takes the surface point nearest to the
/// point; only outwards over edges that the projection met.
Eigen::Vector2d continuation(const NurbsSurface& surface, const Eigen::Vector2d& at,
                             std::array<bool, 2> isClosed,
                             const Eigen::Matrix<double, 3, 2>& tangents, const Point& offset) {
    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    const Eigen::Matrix2d metric = tangents.transpose() * tangents;
    if (metric.determinant() > 1e-20 * metric.trace() * metric.trace()) {
        step = metric.inverse() * (tangents.transpose() * offset);
    }
    for (int axis = 0; axis < 2; ++axis) {
        const KnotVector& knots = direction(surface, axis);
        const bool leaves = !isClosed[axis] && ((at[axis] <= knots.first() && step[axis] < 0) ||
                                                (at[axis] >= knots.last() && step[axis] > 0));
        if (!leaves) {
            step[axis] = 0;
        }
    }
    return step;
}

/// A parameter next to a knot line lies on it: else rounding would cut corners off
/// polygons along it, each time in another way.
double onKnotLine(const KnotVector& knots, double x) {
    constexpr double next = 1e-8; // of a knot span
    const std::vector<double>& breakpoints = knots.breakpoints();
    const auto above = std::lower_bound(breakpoints.begin(), breakpoints.end(), x);
    const auto upper = above == breakpoints.begin() ? above + 1
                       : above == breakpoints.end() ? above - 1
                                                    : above;
    const double first = *(upper - 1), last = *upper;
    for (const double knot : {first, last}) {
        if (std::abs(x - knot) <= next * (last - first)) {
            return knot;
        }
    }
    return x;
}

/// The corner whose parameter is farthest from a seam: the others follow it.
int farthestFromSeam(const KnotVector& knots, int axis,
                     const std::array<ProjectedCorner, 3>& corners) {
    const double middle = 0.5 * (knots.first() + knots.last());
    int best = -1;
    for (int i = 0; i < 3; ++i) {
        if (!corners[i].isFree[axis] &&
            (best < 0 ||
             std::abs(corners[i].at[axis] - middle) < std::abs(corners[best].at[axis] - middle))) {
            best = i;
        }
    }
    return std::max(best, 0);
}

void unwrap(const NurbsSurface& surface, std::array<bool, 2> isClosed,
            std::array<ProjectedCorner, 3>& corners) {
    for (int axis = 0; axis < 2; ++axis) {
        if (!isClosed[axis]) {
            continue;
        }
        const KnotVector& knots = direction(surface, axis);
        const double period = knots.last() - knots.first();
        const double reference = corners[farthestFromSeam(knots, axis, corners)].at[axis];
        for (ProjectedCorner& corner : corners) {
            corner.at[axis] -= period * std::round((corner.at[axis] - reference) / period);
        }
    }
}

} // namespace

ProjectedCorner projectedCorner(const NurbsSurface& surface,
                                const geometry::SurfaceProjector& projector,
                                std::array<bool, 2> isClosed, const Point& point) {
    const geometry::SurfaceProjection found = projector.closest(point);
    const Points d = surface.derivatives(found.xi, found.eta, 1);
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << d.row(1).transpose(), d.row(2).transpose();
    const Point offset = point - d.row(0).transpose();

    ProjectedCorner corner;
    corner.at = {found.xi, found.eta};
    const Eigen::Vector2d step = continuation(surface, corner.at, isClosed, tangents, offset);
    for (int axis = 0; axis < 2; ++axis) {
        corner.at[axis] = onKnotLine(direction(surface, axis), corner.at[axis] + step[axis]);
    }
    corner.gap = (offset - tangents * step).norm();
    corner.converged = found.converged;
    const double longest = tangents.colwise().norm().maxCoeff();
    for (int axis = 0; axis < 2; ++axis) {
        corner.isFree[axis] = tangents.col(axis).norm() < 1e-9 * longest;
    }
    return corner;
}

Polygon parameterPolygon(const NurbsSurface& surface, std::array<bool, 2> isClosed,
                         const std::array<ProjectedCorner, 3>& projected) {
    std::array<ProjectedCorner, 3> corners = projected;
    unwrap(surface, isClosed, corners);
    Polygon polygon;
    for (int i = 0; i < 3; ++i) {
        const ProjectedCorner& corner = corners[i];
        const int freeAxis = corner.isFree[0] ? 0 : corner.isFree[1] ? 1 : -1;
        if (freeAxis < 0) {
            polygon.push_back(corner.at);
            continue;
        }
        for (const int neighbour : {(i + 2) % 3, (i + 1) % 3}) {
            Eigen::Vector2d end = corner.at;
            end[freeAxis] = corners[neighbour].at[freeAxis];
            polygon.push_back(end);
        }
    }
    if (signedArea(polygon) < 0) {
        std::reverse(polygon.begin(), polygon.end());
    }
    return polygon;
}

} // namespace tokay::mapper
