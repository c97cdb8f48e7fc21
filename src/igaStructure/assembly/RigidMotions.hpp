// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// Which rigid motions of a body its supports leave free. A motion has six
/// components: translations along x, y and z, and rotations about axes of these
/// directions through the body's centre, lengths being relative to its size.
class RigidMotions {
  public:
    using Components = Eigen::Matrix<double, 6, 1>;

    /// @param points  n x 3 all over the body: their mean is the centre, the
    ///                diagonal of the box around them the size [m]
    explicit RigidMotions(const geometry::Points& points);

    /// Displacement of a point by each of the six motions, relative to the size.
    Eigen::Matrix<double, 3, 6> at(const geometry::Point& x) const;

    /// Holds what is linear in the motion's components.
    /// @param rows  n x 6, of order one
    void hold(const Eigen::MatrixXd& rows);

    /// Holds the displacement of a point along a unit vector.
    void holdPoint(const geometry::Point& x, const Eigen::Vector3d& direction);

    /// Holds the rotation about a unit vector.
    void holdRotation(const Eigen::Vector3d& axis);

    /// Leaves what a body of the plane z = 0 can do.
    void holdInPlane();

    /// In words, as "translation along x", "rotation about z through (0, 1, 0)";
    /// along axes of space where possible; none: empty. An axis that may lie
    /// anywhere has no point.
    std::vector<std::string> freeOnes() const;

  private:
    geometry::Point centre_;
    double size_;
    Eigen::Matrix<double, 6, 6> held_; ///< sum of r^T r over all rows held
};

} // namespace tokay::structure
