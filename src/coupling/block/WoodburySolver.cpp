// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/WoodburySolver.hpp"

#include <algorithm>

namespace tokay::coupling {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Of c, relative: a tenth of what Newton's method leaves of the block system at the coupling's
/// usual tolerance of 1e-4.
constexpr double tolerance = 1e-6;

/// More refinements than this cost more than they save: a new matrix serves later calls too.
constexpr int maxRefinements = 4;

/// Number of columns, from the first, in which two products are the same.
int nEqualColumns(const MatrixXd& A, const MatrixXd& B, int nColumns, const LowRankMatrix& J) {
    if (J.rank() == 0 || A.rows() != J.A().rows() || B.rows() != J.B().rows()) {
        return 0;
    }
    const int most = std::min(nColumns, J.rank());
    int n = 0;
    while (n < most && A.col(n) == J.A().col(n) && B.col(n) == J.B().col(n)) {
        ++n;
    }
    return n;
}

} // namespace

VectorXd WoodburySolver::solve(const LowRankMatrix& J, const VectorXd& b) {
    const VectorXd y = structure_.responses(b);
    if (J.rank() == 0) {
        return y;
    }
    const VectorXd rightHandSide = J.B().transpose() * structure_.variations(y);
    const bool isNew = nEqualColumns(A_, B_, nKept_, J) == 0;
    update(J);
    Refined refined = refine(J, rightHandSide);
    if (!refined.converged && !isNew) {
        forget();
        update(J);
        refined = refine(J, rightHandSide);
    }
    return y + refined.driven;
}

WoodburySolver::Refined WoodburySolver::refine(const LowRankMatrix& J,
                                               const VectorXd& rightHandSide) {
    VectorXd c = capacitance_.solve(rightHandSide);
    Refined refined{};
    double before = rightHandSide.norm();
    const double target = tolerance * before;
    for (int refinement = 0;; ++refinement) {
        refined.driven = structure_.responses(J.A() * c);
        const VectorXd defect =
            rightHandSide - c + J.B().transpose() * structure_.variations(refined.driven);
        const double size = defect.norm();
        refined.converged = size <= target;
        if (!(size > target && size < 0.5 * before) || refinement == maxRefinements) {
            return refined;
        }
        before = size;
        c += capacitance_.solve(defect);
    }
}

void WoodburySolver::update(const LowRankMatrix& J) {
    const int nEqual = nEqualColumns(A_, B_, nKept_, J);
    const int rank = J.rank();
    if (nEqual == rank && nKept_ == rank) {
        return;
    }
    const int nNew = rank - nEqual;
    MatrixXd PZ(J.B().rows(), rank);
    PZ.leftCols(nEqual) = PZ_.leftCols(nEqual);
    MatrixXd BtPZ(rank, rank);
    BtPZ.topLeftCorner(nEqual, nEqual) = BtPZ_.topLeftCorner(nEqual, nEqual);
    if (nNew > 0) {
        PZ.rightCols(nNew) = structure_.variations(structure_.responses(J.A().rightCols(nNew)));
    }
    BtPZ.bottomLeftCorner(nNew, nEqual).noalias() =
        J.B().rightCols(nNew).transpose() * PZ.leftCols(nEqual);
    BtPZ.rightCols(nNew).noalias() = J.B().transpose() * PZ.rightCols(nNew);
    A_ = J.A();
    B_ = J.B();
    PZ_ = std::move(PZ);
    BtPZ_ = std::move(BtPZ);
    nKept_ = rank;
    capacitance_.compute(MatrixXd::Identity(rank, rank) - BtPZ_);
}

} // namespace tokay::coupling
