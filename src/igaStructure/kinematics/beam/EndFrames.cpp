// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/EndFrames.hpp"

#include "common/errors.hpp"
#include "igaStructure/kinematics/curvePoints.hpp"

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
      toDisplacements_(fixed_.size(), fixed_.size()), toUnknowns_(fixed_.size(), fixed_.size()),
      motions_(curve.controlPoints()) {
    toDisplacements_.setIdentity();
    toUnknowns_.setIdentity();
    holdWhatIsNoMotion(curve);
    for (const BeamSupport& support : supports) {
        hold(curve, support);
    }
    for (std::size_t k = 0; k < supports.size(); ++k) {
        addOwner(owners_, heldBy(supports[k]), static_cast<int>(k));
    }
    trace_ = traceOf(curve, supports);
    const bool allRotations =
        std::count_if(supports.begin(), supports.end(),
                      [](const BeamSupport& support) { return support.rotation; }) > 1;
    if (allRotations && curve.nControlPoints() < 4) {
        throw InputError("both ends of the line hold their rotation, which needs at least 4 "
                         "control points: use more elements or a higher degree");
    }
}

// Of the control points at the ends, which are on the line.
SupportTrace EndFrames::traceOf(const geometry::NurbsCurve& curve,
                                const std::vector<BeamSupport>& supports) const {
    std::vector<SupportPoint> points;
    std::vector<bool> moving(fixed_.size(), false);
    std::vector<bool> atRest = moving;
    for (const BeamSupport& support : supports) {
        const int k = support.end == BeamEnd::start ? 0 : curve.nControlPoints() - 1;
        const std::array<bool, 3> held = {support.x, support.y, support.z};
        std::vector<bool>& own = support.motion ? moving : atRest;
        for (int c = 0; c < dimension_; ++c) {
            own[dimension_ * k + c] = own[dimension_ * k + c] || held[c];
        }
        if (support.motion) {
            const geometry::Point end = curve.controlPoints().row(k);
            points.push_back({{k}, Eigen::VectorXd::Ones(1), 1, end, held, support.motion});
        }
    }
    return {std::move(points), movingOnly(std::move(moving), atRest), dimension_};
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

// Unknowns of the end's control point, and of the next one if it holds the rotation.
std::vector<bool> EndFrames::heldBy(const BeamSupport& support) const {
    std::vector<bool> held(fixed_.size(), false);
    const int n = static_cast<int>(held.size()) / dimension_;
    const bool isStart = support.end == BeamEnd::start;
    const bool own[3] = {support.x, support.y, support.z};
    for (int c = 0; c < dimension_; ++c) {
        held[dimension_ * (isStart ? 0 : n - 1) + c] = own[c];
        held[dimension_ * (isStart ? 1 : n - 2) + c] = support.rotation && c > 0;
    }
    return held;
}

void EndFrames::holdRotation(int first, int second, const Vector3d& tangent) {
    const Matrix3d axes = frame(tangent, dimension_);
    const Matrix3d across = Matrix3d::Identity() - tangent * tangent.transpose();
    const Matrix3d back = -axes.transpose() * across;
    for (int i = 0; i < dimension_; ++i) {
        for (int j = 0; j < dimension_; ++j) {
            const int row = dimension_ * second + i;
            toDisplacements_.coeffRef(row, dimension_ * second + j) = axes(i, j);
            toDisplacements_.coeffRef(row, dimension_ * first + j) = across(i, j);
            toUnknowns_.coeffRef(row, dimension_ * second + j) = axes(j, i);
            toUnknowns_.coeffRef(row, dimension_ * first + j) = back(i, j);
        }
    }
    toDisplacements_.makeCompressed();
    toUnknowns_.makeCompressed();
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

Eigen::VectorXd EndFrames::onControlPoints(const Eigen::VectorXd& onUnknowns) const {
    return isIdentity_ ? onUnknowns : Eigen::VectorXd(toUnknowns_.transpose() * onUnknowns);
}

SparseMatrix EndFrames::matrix(const SparseMatrix& ofControlPoints) const {
    if (isIdentity_) {
        return ofControlPoints;
    }
    const SparseMatrix transposed = toDisplacements_.transpose();
    return transposed * SparseMatrix(ofControlPoints * toDisplacements_);
}

} // namespace tokay::structure
