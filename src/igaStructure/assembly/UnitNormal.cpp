// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/UnitNormal.hpp"

#include <Eigen/Geometry>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d skew(const Vector3d& a) {
    Matrix3d matrix;
    matrix << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
    return matrix;
}

UnitNormal::UnitNormal(const Vector3d& a1, const Vector3d& a2)
    : a1_(a1), a2_(a2), normal_(a1.cross(a2)), area_(normal_.norm()) {
    normal_ /= area_;
}

Eigen::Matrix<double, 3, 6> UnitNormal::derivative() const {
    const Matrix3d projector = (Matrix3d::Identity() - normal_ * normal_.transpose()) / area_;
    Eigen::Matrix<double, 3, 6> derivative;
    derivative.leftCols<3>() = -projector * skew(a2_);
    derivative.rightCols<3>() = projector * skew(a1_);
    return derivative;
}

Vector6d UnitNormal::gradient(const Vector3d& direction) const {
    const Vector3d projected = (direction - direction.dot(normal_) * normal_) / area_;
    Vector6d gradient;
    gradient << a2_.cross(projected), projected.cross(a1_);
    return gradient;
}

// With c = a1 x a2 and f(c) = direction . c / |c|: C^T f'' C plus what the second
// derivative of c, which mixes a1 and a2, gives with f'.
Matrix6d UnitNormal::hessian(const Vector3d& direction) const {
    const double along = direction.dot(normal_);
    const Vector3d across = direction - along * normal_;
    const Matrix3d curvature = -(across * normal_.transpose() + normal_ * across.transpose() +
                                 along * (Matrix3d::Identity() - normal_ * normal_.transpose())) /
                               (area_ * area_);
    const Matrix3d C1 = -skew(a2_);
    const Matrix3d C2 = skew(a1_);
    const Matrix3d f1 = curvature * C1;
    const Matrix3d f2 = curvature * C2;
    const Matrix3d mixed = skew(across) / area_;
    Matrix6d hessian;
    hessian.topLeftCorner<3, 3>().noalias() = C1.transpose() * f1;
    hessian.bottomRightCorner<3, 3>().noalias() = C2.transpose() * f2;
    hessian.topRightCorner<3, 3>().noalias() = C1.transpose() * f2;
    hessian.topRightCorner<3, 3>() -= mixed;
    hessian.bottomLeftCorner<3, 3>() = hessian.topRightCorner<3, 3>().transpose();
    return hessian;
}

} // namespace tokay::structure
