// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace tokay::geometry {

/// A geometry of n parameters near one of them, as seen from a point.
template <int n>
struct Osculation {
    /// Vector from the point to the geometry.
    Point offset;
    /// Column i: derivative by parameter i.
    Eigen::Matrix<double, 3, n> tangents;
    /// Second derivatives times the offset.
    Eigen::Matrix<double, n, n> curvature;
};

template <int n>
struct ClosestParameter {
    Eigen::Matrix<double, n, 1> parameter;
    Point offset;
    bool converged;
};

namespace closestParameterDetail {

/// Step that minimises the quadratic model over the free parameters; Newton's
/// if the Hessian is safely positive there, else Gauss-Newton's.
template <int n>
Eigen::Matrix<double, n, 1> modelStep(const Osculation<n>& at,
                                      const Eigen::Matrix<double, n, 1>& gradient,
                                      const Eigen::Array<bool, n, 1>& isFree) {
    using Matrix = Eigen::Matrix<double, n, n>;
    const Matrix gaussNewton = at.tangents.transpose() * at.tangents;
    if (gaussNewton.trace() == 0) { // a geometry shrunk to a point
        return Eigen::Matrix<double, n, 1>::Zero();
    }
    Matrix newton = gaussNewton + at.curvature;
    Eigen::Matrix<double, n, 1> rhs = -gradient;
    Matrix fallback = gaussNewton;
    // A degenerate tangent (pole) leaves its parameter where it is.
    fallback.diagonal().array() += 1e-14 * gaussNewton.trace();
    for (int i = 0; i < n; ++i) {
        if (!isFree[i]) {
            rhs[i] = 0;
            for (Matrix* matrix : {&newton, &fallback}) {
                matrix->row(i).setZero();
                matrix->col(i).setZero();
                (*matrix)(i, i) = 1;
            }
        }
    }
    const bool isPositive =
        (newton.diagonal().array() > 1e-3 * fallback.diagonal().array()).all() &&
        newton.determinant() > 1e-3 * fallback.determinant();
    return (isPositive ? newton : fallback).inverse() * rhs;
}

} // namespace closestParameterDetail

/// Minimises the distance over the parameter box [lower, upper]: projected
/// Newton with backtracking.
/// @param osculate  parameter -> Osculation<n>
/// @param size      length in space to which the tolerance is relative
template <int n, class Osculate>
ClosestParameter<n> closestParameter(const Osculate& osculate,
                                     const Eigen::Matrix<double, n, 1>& lower,
                                     const Eigen::Matrix<double, n, 1>& upper,
                                     Eigen::Matrix<double, n, 1> x, double size) {
    using Vector = Eigen::Matrix<double, n, 1>;
    constexpr int maxIterations = 100;
    // Below this step in space a gain in distance is lost in rounding.
    const double trusted = 1e-6 * size, tolerance = 1e-12 * size;

    Osculation<n> at = osculate(x);
    for (int iteration = 0; iteration < maxIterations; ++iteration) {
        const Vector gradient = at.tangents.transpose() * at.offset;
        const Eigen::Array<bool, n, 1> isFree =
            !((x.array() <= lower.array() && gradient.array() > 0) ||
              (x.array() >= upper.array() && gradient.array() < 0));
        const auto moved = [&](const Vector& step) {
            return Vector((x + step).cwiseMax(lower).cwiseMin(upper));
        };

        Vector step = closestParameterDetail::modelStep<n>(at, gradient, isFree);
        Vector next = moved(step);
        double length = (at.tangents * (next - x)).norm();
        Osculation<n> there = osculate(next);
        for (int halving = 0;
             length > trusted && there.offset.squaredNorm() > at.offset.squaredNorm(); ++halving) {
            // Clipping can spoil a coupled step; the scaled gradient always descends.
            if (halving == 8) {
                step = -isFree.template cast<double>() * gradient.array() /
                       at.tangents.colwise().squaredNorm().transpose().array().max(1e-300);
            }
            step *= 0.5;
            next = moved(step);
            length = (at.tangents * (next - x)).norm();
            there = osculate(next);
        }
        x = next;
        at = there;
        if (length <= tolerance) {
            return {x, at.offset, true};
        }
    }
    return {x, at.offset, false};
}

} // namespace tokay::geometry
