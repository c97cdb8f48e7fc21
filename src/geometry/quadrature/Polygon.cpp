// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/Polygon.hpp"

namespace tokay::geometry {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// @param inside  is overwritten
void clipByHalfPlane(const Polygon& polygon, const Eigen::Vector2d& normal, double offset,
                     Polygon& inside) {
    inside.clear();
    inside.reserve(polygon.size() + 2);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double beyondA = normal.dot(a) - offset, beyondB = normal.dot(b) - offset;
        if (beyondA <= 0) {
            inside.push_back(a);
        }
        if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0)) {
            inside.push_back(a + beyondA / (beyondA - beyondB) * (b - a));
        }
    }
}

} // namespace

double signedArea(const Polygon& polygon) {
    double twice = 0;
    // About a corner: far from the origin no digits are lost.
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    }
    return 0.5 * twice;
}

Polygon clippedByHalfPlane(const Polygon& polygon, const Eigen::Vector2d& normal, double offset) {
    Polygon inside;
    clipByHalfPlane(polygon, normal, offset, inside);
    return inside;
}

Polygon clippedByConvex(const Polygon& polygon, const Polygon& convex) {
    Polygon inside = polygon, clipped;
    for (std::size_t i = 0; i < convex.size() && !inside.empty(); ++i) {
        const Eigen::Vector2d side = convex[(i + 1) % convex.size()] - convex[i];
        const Eigen::Vector2d outward(side[1], -side[0]);
        clipByHalfPlane(inside, outward, outward.dot(convex[i]), clipped);
        inside.swap(clipped);
    }
    return inside;
}

Polygon clippedByRectangle(const Polygon& polygon, const Eigen::Vector2d& lower,
                           const Eigen::Vector2d& upper) {
    Polygon inside = polygon;
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector2d unit = Eigen::Vector2d::Unit(axis);
        inside = clippedByHalfPlane(inside, unit, upper[axis]);
        inside = clippedByHalfPlane(inside, -unit, -lower[axis]);
    }
    return inside;
}

} // namespace tokay::geometry
