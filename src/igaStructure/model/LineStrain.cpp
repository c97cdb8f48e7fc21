#include "igaStructure/model/LineStrain.hpp"

namespace tokay::structure {

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

// Change of the tangent's angle by the parameter, (a x c) / (a . a).
double turning(const LineDerivatives& x) {
    return cross(x.first, x.second) / x.first.squaredNorm();
}

Vector4d turningGradient(const LineDerivatives& x) {
    const double square = x.first.squaredNorm();
    Vector4d gradient;
    gradient << -turned(x.second) / square - 2 * turning(x) / square * x.first,
        turned(x.first) / square;
    return gradient;
}

Matrix4d turningHessian(const LineDerivatives& x) {
    const Vector2d& a = x.first;
    const double square = a.squaredNorm();
    const Vector2d byFirst = -turned(x.second); // gradient of a x c by a
    Matrix2d mixed;                             // of a x c
    mixed << 0, 1, -1, 0;
    Matrix4d hessian = Matrix4d::Zero();
    hessian.topLeftCorner<2, 2>() =
        -2 * (byFirst * a.transpose() + a * byFirst.transpose()) / (square * square) +
        turning(x) / square * (8 / square * a * a.transpose() - 2 * Matrix2d::Identity());
    hessian.topRightCorner<2, 2>() =
        mixed / square - 2 / (square * square) * a * turned(a).transpose();
    hessian.bottomLeftCorner<2, 2>() = hessian.topRightCorner<2, 2>().transpose();
    return hessian;
}

// Derivative of turning() by the parameter.
double turningSlope(const LineDerivatives& x, const Vector2d& third) {
    const double square = x.first.squaredNorm();
    return (cross(x.first, third) - 2 * turning(x) * x.first.dot(x.second)) / square;
}

// Variation of turningSlope() along a displacement.
double turningSlopeVariation(const LineDerivatives& x, const Vector2d& third,
                             const LineDerivatives& u, const Vector2d& uThird) {
    const double square = x.first.squaredNorm();
    Vector4d motion;
    motion << u.first, u.second;
    const double turningVariation = turningGradient(x).dot(motion);
    const double numerator = cross(u.first, third) + cross(x.first, uThird) -
                             2 * turningVariation * x.first.dot(x.second) -
                             2 * turning(x) * (u.first.dot(x.second) + x.first.dot(u.second));
    return (numerator - turningSlope(x, third) * 2 * x.first.dot(u.first)) / square;
}

} // namespace

LineStrain::LineStrain(const LineDerivatives& reference, const LineDerivatives& displacement,
                       Strains strains)
    : axialHessian(Matrix4d::Zero()), curvatureHessian(Matrix4d::Zero()) {
    const double square = reference.first.squaredNorm();
    const double length = std::sqrt(square);
    axialGradient.setZero();
    axialHessian.topLeftCorner<2, 2>() = Matrix2d::Identity() / square;
    if (strains == Strains::linear) {
        Vector4d u;
        u << displacement.first, displacement.second;
        axialGradient.head<2>() = reference.first / square;
        curvatureGradient = turningGradient(reference) / length;
        axial = axialGradient.dot(u);
        curvature = curvatureGradient.dot(u);
        return;
    }
    const LineDerivatives x{reference.first + displacement.first,
                            reference.second + displacement.second};
    axialGradient.head<2>() = x.first / square;
    // Not a difference of squares: that loses the digits of small strains.
    axial = displacement.first.dot(reference.first + 0.5 * displacement.first) / square;
    curvature = (turning(x) - turning(reference)) / length;
    curvatureGradient = turningGradient(x) / length;
    curvatureHessian = turningHessian(x) / length;
}

double curvatureSlope(const LineDerivatives& reference, const Vector2d& referenceThird,
                      const LineDerivatives& displacement, const Vector2d& displacementThird,
                      Strains strains) {
    const double square = reference.first.squaredNorm();
    const LineStrain strain(reference, displacement, strains);
    double slope; // of the turning
    if (strains == Strains::linear) {
        slope = turningSlopeVariation(reference, referenceThird, displacement, displacementThird);
    } else {
        const LineDerivatives x{reference.first + displacement.first,
                                reference.second + displacement.second};
        slope = turningSlope(x, referenceThird + displacementThird) -
                turningSlope(reference, referenceThird);
    }
    return (slope - strain.curvature * reference.first.dot(reference.second) / std::sqrt(square)) /
           square;
}

} // namespace tokay::structure
