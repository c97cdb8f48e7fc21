// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/GrowingLu.hpp"

#include <Eigen/LU>

#include <cassert>

namespace tokay::coupling {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Eigen::VectorXi;

void GrowingLu::append(const MatrixXd& right, const MatrixXd& bottom, const MatrixXd& corner) {
    const Eigen::Index n = size();
    const Eigen::Index k = corner.rows();
    assert(corner.cols() == k && right.rows() == n && right.cols() == k);
    assert(bottom.rows() == k && bottom.cols() == n);
    MatrixXd upper = right(rows_.head(n), Eigen::all);
    MatrixXd lower = bottom;
    lu_.triangularView<Eigen::UnitLower>().solveInPlace(upper);
    lu_.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(lower);
    const Eigen::PartialPivLU<MatrixXd> schur(corner - lower * upper);

    lu_.conservativeResize(n + k, n + k);
    lu_.topRightCorner(n, k) = upper;
    lu_.bottomLeftCorner(k, n) = schur.permutationP() * lower;
    lu_.bottomRightCorner(k, k) = schur.matrixLU();
    rows_.conservativeResize(n + k);
    for (Eigen::Index i = 0; i < k; ++i) {
        rows_[n + schur.permutationP().indices()[i]] = static_cast<int>(n + i);
    }
}

VectorXd GrowingLu::solve(const VectorXd& b) const {
    VectorXd x = b(rows_.head(size()));
    lu_.triangularView<Eigen::UnitLower>().solveInPlace(x);
    lu_.triangularView<Eigen::Upper>().solveInPlace(x);
    return x;
}

} // namespace tokay::coupling
