// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/BeamStrain.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace tokay::structure {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix36d = Eigen::Matrix<double, 3, 6>;

// The matrix of v -> a x v.
Matrix3d crossMatrix(const Vector3d& a) {
    Matrix3d matrix;
    matrix << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
    return matrix;
}

// Rotation of the tangent by the parameter, (a x c) / (a . a).
Vector3d turning(const BeamDerivatives& x) {
    return x.first.cross(x.second) / x.first.squaredNorm();
}

Matrix36d turningGradient(const BeamDerivatives& x) {
    const double square = x.first.squaredNorm();
    Matrix36d gradient;
    gradient << -crossMatrix(x.second) / square - 2 / square * turning(x) * x.first.transpose(),
        crossMatrix(x.first) / square;
    return gradient;
}

// Second derivative of moment . turning.
BeamStrain::Matrix6d turningHessian(const BeamDerivatives& x, const Vector3d& moment) {
    const Vector3d& a = x.first;
    const double square = a.squaredNorm();
    const Vector3d byFirst = x.second.cross(moment); // gradient of moment . (a x c) by a
    BeamStrain::Matrix6d hessian = BeamStrain::Matrix6d::Zero();
    hessian.topLeftCorner<3, 3>() =
        -2 * (byFirst * a.transpose() + a * byFirst.transpose()) / (square * square) +
        moment.dot(turning(x)) / square *
            (8 / square * a * a.transpose() - 2 * Matrix3d::Identity());
    hessian.topRightCorner<3, 3>() =
        -crossMatrix(moment) / square - 2 / (square * square) * a * moment.cross(a).transpose();
    hessian.bottomLeftCorner<3, 3>() = hessian.topRightCorner<3, 3>().transpose();
    return hessian;
}

// Derivative of turning() by the parameter.
Vector3d turningSlope(const BeamDerivatives& x, const Vector3d& third) {
    const double square = x.first.squaredNorm();
    return (x.first.cross(third) - 2 * x.first.dot(x.second) * turning(x)) / square;
}

// Variation of turningSlope() along a displacement.
Vector3d turningSlopeVariation(const BeamDerivatives& x, const Vector3d& third,
                               const BeamDerivatives& u, const Vector3d& uThird) {
    const double square = x.first.squaredNorm();
    Eigen::Matrix<double, 6, 1> motion;
    motion << u.first, u.second;
    const Vector3d turningVariation = turningGradient(x) * motion;
    const Vector3d numerator = u.first.cross(third) + x.first.cross(uThird) -
                               2 * x.first.dot(x.second) * turningVariation -
                               2 * (u.first.dot(x.second) + x.first.dot(u.second)) * turning(x);
    return (numerator - 2 * x.first.dot(u.first) * turningSlope(x, third)) / square;
}

BeamDerivatives sum(const BeamDerivatives& a, const BeamDerivatives& b) {
    return {a.first + b.first, a.second + b.second};
}

} // namespace

BeamStrain::BeamStrain(const BeamDerivatives& reference, const BeamDerivatives& displacement,
                       Strains strains)
    : axialHessian(1 / reference.first.squaredNorm()), x_(sum(reference, displacement)),
      length_(reference.first.norm()), isLinear_(strains == Strains::linear) {
    if (isLinear_) {
        Eigen::Matrix<double, 6, 1> u;
        u << displacement.first, displacement.second;
        axialGradient = axialHessian * reference.first;
        curvatureGradient = turningGradient(reference) / length_;
        axial = axialGradient.dot(displacement.first);
        curvature = curvatureGradient * u;
        return;
    }
    axialGradient = axialHessian * x_.first;
    // Not a difference of squares: that loses the digits of small strains.
    axial = axialHessian * displacement.first.dot(reference.first + 0.5 * displacement.first);
    curvature = (turning(x_) - turning(reference)) / length_;
    curvatureGradient = turningGradient(x_) / length_;
}

BeamStrain::Matrix6d BeamStrain::curvatureHessian(const Vector3d& moment) const {
    return isLinear_ ? Matrix6d(Matrix6d::Zero()) : turningHessian(x_, moment / length_);
}

Vector3d curvatureSlope(const BeamDerivatives& reference, const Vector3d& referenceThird,
                        const BeamDerivatives& displacement, const Vector3d& displacementThird,
                        Strains strains) {
    const double square = reference.first.squaredNorm();
    const BeamStrain strain(reference, displacement, strains);
    const Vector3d slope = // of the turning
        strains == Strains::linear
            ? turningSlopeVariation(reference, referenceThird, displacement, displacementThird)
            : turningSlope(sum(reference, displacement), referenceThird + displacementThird) -
                  turningSlope(reference, referenceThird);
    return (slope - reference.first.dot(reference.second) / std::sqrt(square) * strain.curvature) /
           square;
}

} // namespace tokay::structure
