// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/NurbsVolume.hpp"

#include "common/errors.hpp"
#include "geometry/spline/rational.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

const std::array<const char*, 6> sideNames = {"left", "right", "bottom", "top", "back", "front"};

/// Quotient rule for each function.
void makeRational(const Eigen::VectorXd& weights, Eigen::Matrix<double, 4, Eigen::Dynamic>& N) {
    N *= weights.asDiagonal();
    const Eigen::Vector4d sums = N.rowwise().sum();
    N.row(0) /= sums[0];
    for (int i = 1; i < 4; ++i) {
        N.row(i) = (N.row(i) - sums[i] * N.row(0)).eval() / sums[0];
    }
}

} // namespace

Side sideFromName(const std::string& name) {
    const auto found = std::find(sideNames.begin(), sideNames.end(), name);
    if (found == sideNames.end()) {
        throw InputError(fmt::format("there is no side \"{}\": a volume has the sides {}", name,
                                     fmt::join(sideNames, ", ")));
    }
    return static_cast<Side>(found - sideNames.begin());
}

std::string nameOf(Side side) {
    return sideNames[static_cast<int>(side)];
}

NurbsVolume::NurbsVolume(KnotVector u, KnotVector v, KnotVector w, Points controlPoints,
                         Eigen::VectorXd weights)
    : directions_{std::move(u), std::move(v), std::move(w)},
      controlPoints_(std::move(controlPoints)),
      weights_(checkedWeights(std::move(weights), nControlPoints(), "the volume")) {
    checkControlPoints(controlPoints_, nControlPoints(), "the volume");
}

VolumeBasis NurbsVolume::basis(const Eigen::Vector3d& parameters) const {
    std::array<Eigen::Matrix2Xd, 3> N;
    Eigen::Vector3i first;
    for (int axis = 0; axis < 3; ++axis) {
        const KnotVector& knots = directions_[axis];
        const int span = knots.findSpan(parameters[axis]);
        N[axis].resize(2, knots.degree() + 1);
        knots.valuesAndSlopes(span, parameters[axis], N[axis]);
        first[axis] = span - knots.degree();
    }
    VolumeBasis basis;
    basis.N.resize(4, N[0].cols() * N[1].cols() * N[2].cols());
    for (int k = 0, column = 0; k < N[2].cols(); ++k) {
        for (int j = 0; j < N[1].cols(); ++j) {
            for (int i = 0; i < N[0].cols(); ++i, ++column) {
                basis.controlPoints.push_back(
                    first[0] + i + u().nBasis() * (first[1] + j + v().nBasis() * (first[2] + k)));
                const double a = N[0](0, i), b = N[1](0, j), c = N[2](0, k);
                basis.N.col(column) << a * b * c, N[0](1, i) * b * c, a * N[1](1, j) * c,
                    a * b * N[2](1, k);
            }
        }
    }
    if (isRational()) {
        makeRational(weights_(basis.controlPoints), basis.N);
    }
    return basis;
}

Point NurbsVolume::point(const Eigen::Vector3d& parameters) const {
    const VolumeBasis b = basis(parameters);
    return (b.N.row(0) * controlPoints_(b.controlPoints, Eigen::all)).transpose();
}

Eigen::Matrix3d NurbsVolume::jacobian(const Eigen::Vector3d& parameters) const {
    const VolumeBasis b = basis(parameters);
    return (b.N.bottomRows<3>() * controlPoints_(b.controlPoints, Eigen::all)).transpose();
}

BoundarySurface NurbsVolume::boundarySurface(Side side) const {
    const int axis = static_cast<int>(side) / 2;
    const bool isLast = static_cast<int>(side) % 2 == 1;
    const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    const std::array<int, 3> steps = {1, u().nBasis(), u().nBasis() * v().nBasis()};
    const int start = isLast ? (directions_[axis].nBasis() - 1) * steps[axis] : 0;

    std::vector<int> numbers;
    for (int j = 0; j < directions_[second].nBasis(); ++j) {
        for (int i = 0; i < directions_[first].nBasis(); ++i) {
            numbers.push_back(start + steps[first] * i + steps[second] * j);
        }
    }
    Eigen::VectorXd weights;
    if (isRational()) {
        weights = weights_(numbers);
    }
    // xi x eta is along zeta, eta x zeta along xi, but xi x zeta against eta.
    return {NurbsSurface(directions_[first], directions_[second],
                         controlPoints_(numbers, Eigen::all), std::move(weights)),
            std::move(numbers), isLast != (axis == 1)};
}

} // namespace tokay::geometry
