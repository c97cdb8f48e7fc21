// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/Triangle.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace tokay::geometry {

Triangle::Triangle(const Point& a, const Point& b, const Point& c) : corners_{a, b, c} {
    const Point u = b - a, v = c - a;
    normal_ = u.cross(v);
    // Dual vectors of u and v in their plane.
    const double squared = normal_.squaredNorm();
    gradients_.row(0) = v.cross(normal_) / squared;
    gradients_.row(1) = normal_.cross(u) / squared;
}

Barycentric Triangle::closest(const Point& point) const {
    const Barycentric foot = barycentric(point);
    if (foot.minCoeff() >= 0) {
        return foot;
    }
    Barycentric best = Barycentric::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const Point edge = corners_[j] - corners_[i];
        const double t = std::clamp((point - corners_[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        const double distance = (corners_[i] + t * edge - point).squaredNorm();
        if (distance < least) {
            least = distance;
            best.setZero();
            best[i] = 1 - t;
            best[j] = t;
        }
    }
    return best;
}

} // namespace tokay::geometry
