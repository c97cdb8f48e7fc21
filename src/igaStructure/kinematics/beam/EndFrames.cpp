// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/EndFrames.hpp"

#include "common/errors.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Columns: the tangent and what is across it; in the plane the last one is z.
Matrix3d frame(const Vector3d& tangent, int dimension) {
    const Vector3d normal =
        dimension == 2 ? Vector3d(-tangent[1], tangent[0], 0) : tangent.unitOrthogonal();
    Matrix3d axes;
    axes << tangent, normal, tangent.cross(normal);
    return axes;
}

} // namespace

EndFrames::EndFrames(const geometry::NurbsCurve& curve, const std::vector<BeamSupport>& supports,
                     int dimension)
    : dimension_(dimension), fixed_(dimension * curve.nControlPoints(), false),
      toDisplacements_(fixed_.size(), fixed_.size()), motions_(curve.controlPoints()) {
    toDisplacements_.setIdentity();
    holdWhatIsNoMotion(curve);
    for (const BeamSupport& support : supports) {
        hold(curve, support);
    }
    const bool allRotations =
        std::count_if(supports.begin(), supports.end(),
                      [](const BeamSupport& support) { return support.rotation; }) > 1;
    if (allRotations && curve.nControlPoints() < 4) {
        throw InputError("both ends of the line hold their rotation, which needs at least 4 "
                         "control points: use more elements or a higher degree");
    }
}

// In space turning about its own chord does not move a straight line, and swings
// a cable, which loads and prestress resist as they do its motions without strain.
void EndFrames::holdWhatIsNoMotion(const geometry::NurbsCurve& curve) {
    if (dimension_ == 2) {
        motions_.holdInPlane();
        return;
    }
    const geometry::Points& points = curve.controlPoints();
    const Vector3d chord = points.row(points.rows() - 1) - points.row(0);
    if (chord.norm() > 0) {
        motions_.holdRotation(chord.normalized());
    }
}

void EndFrames::hold(const geometry::NurbsCurve& curve, const BeamSupport& support) {
    const int n = curve.nControlPoints();
    const int first = support.end == BeamEnd::start ? 0 : n - 1;
    const int second = support.end == BeamEnd::start ? 1 : n - 2;
    const geometry::Points& points = curve.controlPoints();
    const bool held[3] = {support.x, support.y, support.z};
    for (int c = 0; c < dimension_; ++c) {
        if (held[c]) {
            fixed_[dimension_ * first + c] = true;
            motions_.holdPoint(points.row(first), Vector3d::Unit(c));
        }
    }
    if (support.rotation) {
        holdRotation(first, second, (points.row(second) - points.row(first)).normalized());
    }
}

void EndFrames::holdRotation(int first, int second, const Vector3d& tangent) {
    const Matrix3d axes = frame(tangent, dimension_);
    const Matrix3d across = Matrix3d::Identity() - tangent * tangent.transpose();
    for (int i = 0; i < dimension_; ++i) {
        for (int j = 0; j < dimension_; ++j) {
            const int row = dimension_ * second + i;
            toDisplacements_.coeffRef(row, dimension_ * second + j) = axes(i, j);
            toDisplacements_.coeffRef(row, dimension_ * first + j) = across(i, j);
        }
    }
    toDisplacements_.makeCompressed();
    isIdentity_ = false;
    for (int c = 1; c < dimension_; ++c) {
        fixed_[dimension_ * second + c] = true;
        // Turns the tangent towards that axis.
        motions_.holdRotation(tangent.cross(axes.col(c)));
    }
}

Eigen::VectorXd EndFrames::displacements(const Eigen::VectorXd& unknowns) const {
    return isIdentity_ ? unknowns : Eigen::VectorXd(toDisplacements_ * unknowns);
}

Eigen::VectorXd EndFrames::forces(const Eigen::VectorXd& onControlPoints) const {
    return isIdentity_ ? onControlPoints
                       : Eigen::VectorXd(toDisplacements_.transpose() * onControlPoints);
}

SparseMatrix EndFrames::matrix(const SparseMatrix& ofControlPoints) const {
    if (isIdentity_) {
        return ofControlPoints;
    }
    const SparseMatrix transposed = toDisplacements_.transpose();
    return transposed * SparseMatrix(ofControlPoints * toDisplacements_);
}

} // namespace tokay::structure
