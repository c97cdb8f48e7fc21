// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/rational.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

namespace tokay::geometry {

namespace {

/// Beyond it squares and products of a few numbers overflow.
constexpr double largestMagnitude = 1e50;

} // namespace

double binomial(int n, int k) {
    double value = 1;
    for (int i = 1; i <= k; ++i) {
        value = value * (n - k + i) / i;
    }
    return value;
}

Eigen::VectorXd checkedWeights(Eigen::VectorXd weights, int n, const std::string& owner) {
    if (weights.size() == 0) {
        return weights;
    }
    if (weights.size() != n) {
        throw InputError(fmt::format("{} has {} weights for {} control points: give one for each",
                                     owner, weights.size(), n));
    }
    for (int i = 0; i < n; ++i) {
        if (!(weights[i] >= 1 / largestMagnitude && weights[i] <= largestMagnitude)) {
            throw InputError(fmt::format("{}: weight {} is {}, but weights must be positive, from "
                                         "{:g} to {:g}",
                                         owner, i, weights[i], 1 / largestMagnitude,
                                         largestMagnitude));
        }
    }
    if ((weights.array() == weights[0]).all()) {
        return {};
    }
    return weights;
}

void checkControlPoints(const Points& points, int n, const std::string& owner) {
    if (points.rows() != n) {
        throw InputError(fmt::format("{} has {} control points, but its knot vectors need {}",
                                     owner, points.rows(), n));
    }
    for (int i = 0; i < n; ++i) {
        if (!(points.row(i).array().abs() <= largestMagnitude).all()) {
            throw InputError(fmt::format("{}: control point {} is ({}, {}, {}): coordinates must "
                                         "be finite and at most {:g}",
                                         owner, i, points(i, 0), points(i, 1), points(i, 2),
                                         largestMagnitude));
        }
    }
}

Eigen::MatrixXd homogeneous(const Points& points, const Eigen::VectorXd& weights) {
    if (weights.size() == 0) {
        return points;
    }
    Eigen::MatrixXd rows(points.rows(), 4);
    rows << weights.asDiagonal() * points, weights;
    return rows;
}

std::pair<Points, Eigen::VectorXd> dehomogenised(const Eigen::MatrixXd& rows) {
    if (rows.cols() == 3) {
        return {rows, {}};
    }
    const Eigen::VectorXd weights = rows.col(3);
    return {weights.cwiseInverse().asDiagonal() * rows.leftCols(3), weights};
}

} // namespace tokay::geometry
