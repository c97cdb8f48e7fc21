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

} // namespace

VectorXd WoodburySolver::solve(const LowRankMatrix& J, const VectorXd& b) {
    const VectorXd y = structure_.responses(b);
    if (J.rank() == 0) {
        return y;
    }
    const VectorXd rightHandSide = J.B().transpose() * structure_.variations(y);
    const bool isNew = update(J) == 0;
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

/// @return  number of columns that were kept
int WoodburySolver::update(const LowRankMatrix& J) {
    const int nEqual = nEqualColumns(J);
    const int rank = J.rank();
    if (nEqual < capacitance_.size()) {
        capacitance_.clear(); // factors cannot shrink
    }
    if (nEqual < rank) {
        const int nNew = rank - nEqual;
        PZ_.conservativeResize(J.B().rows(), rank);
        PZ_.rightCols(nNew) = structure_.variations(structure_.responses(J.A().rightCols(nNew)));
    }
    kept_ = J.columnMarks();
    const Eigen::Index nFactored = capacitance_.size();
    const Eigen::Index n = rank - nFactored;
    if (n > 0) {
        const auto newB = J.B().rightCols(n);
        const auto newPZ = PZ_.middleCols(nFactored, n);
        capacitance_.append(-(J.B().leftCols(nFactored).transpose() * newPZ),
                            -(newB.transpose() * PZ_.leftCols(nFactored)),
                            MatrixXd::Identity(n, n) - newB.transpose() * newPZ);
    }
    return nEqual;
}

/// Number of columns, from the first, that are kept.
int WoodburySolver::nEqualColumns(const LowRankMatrix& J) const {
    const std::vector<std::uint64_t>& marks = J.columnMarks();
    const auto equal = std::mismatch(kept_.begin(), kept_.end(), marks.begin(), marks.end());
    return static_cast<int>(equal.first - kept_.begin());
}

} // namespace tokay::coupling
