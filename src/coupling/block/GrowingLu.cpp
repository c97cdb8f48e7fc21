// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/GrowingLu.hpp"

#include "common/dense/DenseLu.hpp"

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
    const DenseLu schur(corner - lower * upper);
    const VectorXi rows = schur.rows();

    lu_.conservativeResize(n + k, n + k);
    lu_.topRightCorner(n, k) = upper;
    lu_.bottomLeftCorner(k, n) = lower(rows, Eigen::all);
    lu_.bottomRightCorner(k, k) = schur.factors();
    rows_.conservativeResize(n + k);
    rows_.tail(k) = rows.array() + static_cast<int>(n);
}

VectorXd GrowingLu::solve(const VectorXd& b) const {
    VectorXd x = b(rows_.head(size()));
    lu_.triangularView<Eigen::UnitLower>().solveInPlace(x);
    lu_.triangularView<Eigen::Upper>().solveInPlace(x);
    return x;
}

} // namespace tokay::coupling
