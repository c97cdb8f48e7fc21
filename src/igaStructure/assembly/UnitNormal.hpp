// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::structure {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Unit normal a3 of a surface as a function of its base vectors (a1, a2), with
/// derivatives by these six components.
class UnitNormal {
  public:
    UnitNormal(const Eigen::Vector3d& a1, const Eigen::Vector3d& a2);

    const Eigen::Vector3d& value() const { return normal_; }
    /// Length of a1 x a2.
    double area() const { return area_; }

    /// Derivative of a3.
    Eigen::Matrix<double, 3, 6> derivative() const;

    /// Derivative of direction . a3, the direction being constant.
    Vector6d gradient(const Eigen::Vector3d& direction) const;

    /// Second derivative of direction . a3, the direction being constant.
    Matrix6d hessian(const Eigen::Vector3d& direction) const;

  private:
    Eigen::Vector3d a1_, a2_, normal_;
    double area_;
};

/// The matrix of a cross product: skew(a) b = a x b.
Eigen::Matrix3d skew(const Eigen::Vector3d& a);

} // namespace tokay::structure
