#include "igaStructure/model/EndFrames.hpp"

#include "common/errors.hpp"
#include "igaStructure/model/LineStrain.hpp"

#include <algorithm>

namespace tokay::structure {

using Eigen::Vector2d;

EndFrames::EndFrames(const geometry::NurbsCurve& curve, const std::vector<LineSupport>& supports)
    : fixed_(2 * curve.nControlPoints(), false), toDisplacements_(fixed_.size(), fixed_.size()),
      heldMotions_(0, 3) {
    toDisplacements_.setIdentity();
    for (const LineSupport& support : supports) {
        hold(curve, support);
    }
    const bool allRotations =
        std::count_if(supports.begin(), supports.end(),
                      [](const LineSupport& support) { return support.rotation; }) > 1;
    if (allRotations && curve.nControlPoints() < 4) {
        throw InputError("both ends of the line hold their rotation, which needs at least 4 "
                         "control points: use more elements or a higher degree");
    }
}

void EndFrames::hold(const geometry::NurbsCurve& curve, const LineSupport& support) {
    const int n = curve.nControlPoints();
    const int first = support.end == LineEnd::start ? 0 : n - 1;
    const int second = support.end == LineEnd::start ? 1 : n - 2;
    const geometry::Points& points = curve.controlPoints();
    const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
    const Vector2d x = (points.row(first) - points.colwise().mean()).head<2>().transpose() / size;
    const auto holdMotion = [&](const Eigen::RowVector3d& motion) {
        heldMotions_.conservativeResize(heldMotions_.rows() + 1, 3);
        heldMotions_.bottomRows<1>() = motion;
    };
    if (support.x) {
        fixed_[2 * first] = true;
        holdMotion({1, 0, -x[1]});
    }
    if (support.y) {
        fixed_[2 * first + 1] = true;
        holdMotion({0, 1, x[0]});
    }
    if (!support.rotation) {
        return;
    }
    const Vector2d tangent =
        (points.row(second) - points.row(first)).head<2>().transpose().normalized();
    const Vector2d normal = turned(tangent);
    const Eigen::Matrix2d across = normal * normal.transpose();
    for (int i = 0; i < 2; ++i) {
        toDisplacements_.coeffRef(2 * second + i, 2 * second) = tangent[i];
        toDisplacements_.coeffRef(2 * second + i, 2 * second + 1) = normal[i];
        for (int j = 0; j < 2; ++j) {
            toDisplacements_.coeffRef(2 * second + i, 2 * first + j) = across(i, j);
        }
    }
    toDisplacements_.makeCompressed();
    isIdentity_ = false;
    fixed_[2 * second + 1] = true;
    holdMotion({0, 0, 1});
}

Eigen::VectorXd EndFrames::displacements(const Eigen::VectorXd& unknowns) const {
    return isIdentity_ ? unknowns : Eigen::VectorXd(toDisplacements_ * unknowns);
}

Eigen::VectorXd EndFrames::forces(const Eigen::VectorXd& onControlPoints) const {
    return isIdentity_ ? onControlPoints
                       : Eigen::VectorXd(toDisplacements_.transpose() * onControlPoints);
}

Eigen::SparseMatrix<double>
EndFrames::matrix(const Eigen::SparseMatrix<double>& ofControlPoints) const {
    if (isIdentity_) {
        return ofControlPoints;
    }
    const Eigen::SparseMatrix<double> transposed = toDisplacements_.transpose();
    return transposed * Eigen::SparseMatrix<double>(ofControlPoints * toDisplacements_);
}

} // namespace tokay::structure
