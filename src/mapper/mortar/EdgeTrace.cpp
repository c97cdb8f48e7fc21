// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/EdgeTrace.hpp"

#include "common/dense/SingularValues.hpp"

namespace tokay::mapper {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Singular values below this part of the largest one are zero: such a combination of
/// functions moves the edge by less than this part of itself.
constexpr double zero = 1e-10;

} // namespace

EdgeTrace::EdgeTrace(const MatrixXd& values, const VectorXd& weights) {
    const VectorXd roots = weights.cwiseSqrt();
    const SingularValues svd(roots.asDiagonal() * values);
    const Eigen::Index rank = svd.rank(zero);
    singularValues_ = svd.values.head(rank);
    projection_ = singularValues_.cwiseInverse().asDiagonal() * svd.U.leftCols(rank).transpose() *
                  roots.asDiagonal();
    basis_ = svd.V;
    if (!isSingular()) { // control values themselves: a support may hold one of them
        projection_ = (basis_ * projection_).eval();
        basis_.setIdentity();
    }
}

double EdgeTrace::conditionOnRange() const {
    const double ratio = singularValues_[0] / singularValues_[rank() - 1];
    return ratio * ratio;
}

Eigen::MatrixXd EdgeTrace::coefficients(const Eigen::MatrixXd& atPoints) const {
    return projection_ * atPoints;
}

Eigen::MatrixXd EdgeTrace::forcesAtPoints(const Eigen::MatrixXd& onCoefficients) const {
    return projection_.transpose() * onCoefficients;
}

} // namespace tokay::mapper
