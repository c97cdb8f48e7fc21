// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/dense/SymmetricEigen.hpp"
#include "geometry/spline/Points.hpp"

#include <cmath>

namespace tokay::mapper {

using geometry::Point;
using geometry::Points;

/// Coordinates of a cloud's points along its principal axes, in whole steps of 1e-9 of
/// its extent: what is decided by comparing them depends neither on rounding nor on how
/// the cloud lies in space, unless two axes are alike.
class PrincipalFrame {
  public:
    explicit PrincipalFrame(const Points& cloud) : centre_(cloud.colwise().mean()) {
        const Points centred = cloud.rowwise() - centre_.transpose();
        axes_ = SymmetricEigen(centred.transpose() * centred).vectors;
        for (int i = 0; i < 3; ++i) {
            if (centred.row(0) * axes_.col(i) < 0) {
                axes_.col(i) *= -1;
            }
        }
        const double extent = std::sqrt(centred.rowwise().squaredNorm().maxCoeff());
        step_ = extent > 0 ? 1e-9 * extent : 1;
        coordinates_ = (centred * axes_ / step_).array().round();
    }

    /// n x 3, whole numbers.
    const Points& coordinates() const { return coordinates_; }
    /// Where in space these coordinates are [m].
    Point at(const Point& coordinates) const { return centre_ + step_ * axes_ * coordinates; }

  private:
    Point centre_;
    Eigen::Matrix3d axes_;
    double step_;
    Points coordinates_;
};

} // namespace tokay::mapper
