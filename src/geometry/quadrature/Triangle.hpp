// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <array>

namespace tokay::geometry {

using Barycentric = Eigen::Vector3d;

/// A straight triangle in space.
class Triangle {
  public:
    Triangle(const Point& a, const Point& b, const Point& c);

    const Point& corner(int i) const { return corners_[i]; }
    double area() const { return 0.5 * normal_.norm(); }
    /// Unit normal, right-handed about the corners.
    Point unitNormal() const { return normal_.normalized(); }
    Point at(const Barycentric& b) const {
        return b[0] * corners_[0] + b[1] * corners_[1] + b[2] * corners_[2];
    }

    /// Coordinates of the foot of the perpendicular; they sum to 1, and one is
    /// negative if the foot lies outside. Affine, so linear fields are exact.
    Barycentric barycentric(const Point& point) const {
        const Eigen::Vector2d b = gradients_ * (point - corners_[0]);
        return {1 - b[0] - b[1], b[0], b[1]};
    }

    /// Rows: gradients of the barycentric coordinates 1 and 2 [1/m]; that of 0 is minus their sum.
    const Eigen::Matrix<double, 2, 3>& gradients() const { return gradients_; }

    /// Coordinates, none negative, of the closest point of the triangle.
    Barycentric closest(const Point& point) const;

  private:
    std::array<Point, 3> corners_;
    Point normal_;
    Eigen::Matrix<double, 2, 3> gradients_;
};

} // namespace tokay::geometry
