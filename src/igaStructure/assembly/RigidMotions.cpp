// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/RigidMotions.hpp"

#include "common/dense/SingularValues.hpp"
#include "common/dense/SymmetricEigen.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

// Components are of order one; squares of smaller ones are rounding.
constexpr double nothing = 1e-6;

// Columns that span the motions without an effect on what is held.
MatrixXd nullSpace(const Eigen::Matrix<double, 6, 6>& held) {
    constexpr double rounding = 1e-13;
    const SymmetricEigen modes(held);
    const double none = rounding * std::max(1.0, modes.values[5]);
    return modes.vectors.leftCols((modes.values.array() <= none).count());
}

// A basis of the span of orthonormal columns: axes of space first.
std::vector<Vector3d> readableBasis(const Matrix3Xd& columns) {
    std::vector<Vector3d> basis;
    Matrix3d rest = columns * columns.transpose();
    for (int c = 0; c < 3; ++c) {
        if (rest(c, c) > 1 - nothing) {
            basis.emplace_back(Vector3d::Unit(c));
            rest.row(c).setZero();
            rest.col(c).setZero();
        }
    }
    const SymmetricEigen others(rest);
    for (int k = 0; k < 3; ++k) {
        if (others.values[k] > 0.5) { // of a projector: 0 or 1
            basis.emplace_back(others.vectors.col(k));
        }
    }
    return basis;
}

// No rounding errors, and no zero with a sign.
std::string coordinates(const Vector3d& x, double scale) {
    const auto clean = [&](double value) { return std::abs(value) < nothing * scale ? 0 : value; };
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", clean(x[0]), clean(x[1]), clean(x[2]));
}

std::string axisName(const Vector3d& axis) {
    for (int c = 0; c < 3; ++c) {
        if (axis == Vector3d::Unit(c)) {
            return std::string(1, "xyz"[c]);
        }
    }
    // The first component is positive
    const double first = *std::find_if(axis.begin(), axis.end(),
                                       [](double part) { return std::abs(part) > nothing; });
    return coordinates(std::copysign(1, first) * axis, 1);
}

} // namespace

RigidMotions::RigidMotions(const geometry::Points& points)
    : centre_(points.colwise().mean()),
      size_((points.colwise().maxCoeff() - points.colwise().minCoeff()).norm()) {
    held_.setZero();
}

Eigen::Matrix<double, 3, 6> RigidMotions::at(const geometry::Point& x) const {
    const Vector3d r = (x - centre_) / size_;
    Eigen::Matrix<double, 3, 6> displacement;
    displacement << 1, 0, 0, 0, r[2], -r[1], //
        0, 1, 0, -r[2], 0, r[0],             //
        0, 0, 1, r[1], -r[0], 0;
    return displacement;
}

void RigidMotions::hold(const MatrixXd& rows) {
    held_ += rows.transpose() * rows;
}

void RigidMotions::holdPoint(const geometry::Point& x, const Vector3d& direction) {
    hold(direction.transpose() * at(x));
}

void RigidMotions::holdRotation(const Vector3d& axis) {
    Components row;
    row << 0, 0, 0, axis;
    hold(row.transpose());
}

void RigidMotions::holdInPlane() {
    hold(Components::Unit(2).transpose());
    holdRotation(Vector3d::UnitX());
    holdRotation(Vector3d::UnitY());
}

std::vector<std::string> RigidMotions::freeOnes() const {
    const MatrixXd space = nullSpace(held_);
    if (space.cols() == 0) {
        return {};
    }
    // Right singular vectors of the rotations: those of no singular value translate only.
    const SingularValues svd(space.bottomRows<3>());
    const auto nRotations = (svd.values.array() > nothing).count();
    const Matrix3Xd translations = space.topRows<3>() * svd.V.rightCols(space.cols() - nRotations);
    std::vector<std::string> names;
    for (const Vector3d& direction : readableBasis(translations)) {
        names.push_back("translation along " + axisName(direction));
    }
    const Matrix3Xd axes = svd.U.leftCols(nRotations);
    const Matrix3Xd shifts = space.topRows<3>() * svd.V.leftCols(nRotations) *
                             svd.values.head(nRotations).cwiseInverse().asDiagonal();
    for (const Vector3d& axis : readableBasis(axes)) {
        const Vector3d shift = shifts * (axes.transpose() * axis);
        const Vector3d own = shift - translations * (translations.transpose() * shift);
        std::string name = "rotation about " + axisName(axis);
        const Matrix3Xd moved = translations - axis * (axis.transpose() * translations);
        const SymmetricEigen plane(moved * moved.transpose());
        if (plane.values[1] < nothing) { // ascending: the axis may not move everywhere
            name += " through " + coordinates(centre_ + size_ * axis.cross(own), size_);
        }
        if (std::abs(axis.dot(own)) > nothing) {
            name += " that moves along it";
        }
        names.push_back(name);
    }
    return names;
}

} // namespace tokay::structure
