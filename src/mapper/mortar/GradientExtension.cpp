// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/GradientExtension.hpp"

#include "common/errors.hpp"
#include "mapper/mortar/activeRows.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::mapper {

namespace {

using ColumnMatrix = Eigen::SparseMatrix<double>;

std::vector<int> rowsOfEither(const RowSparseMatrix& a, const RowSparseMatrix& b) {
    const std::vector<int> inA = rowsNotZero(a), inB = rowsNotZero(b);
    std::vector<int> both;
    std::set_union(inA.begin(), inA.end(), inB.begin(), inB.end(), std::back_inserter(both));
    return both;
}

double largest(const ColumnMatrix& matrix) {
    return matrix.coeffs().size() > 0 ? matrix.coeffs().abs().maxCoeff() : 0;
}

void append(const ColumnMatrix& block, Eigen::Index row, Eigen::Index column, double factor,
            std::vector<Eigen::Triplet<double>>& entries) {
    for (int j = 0; j < block.outerSize(); ++j) {
        for (ColumnMatrix::InnerIterator entry(block, j); entry; ++entry) {
            entries.emplace_back(static_cast<int>(row + entry.row()),
                                 static_cast<int>(column + entry.col()), factor * entry.value());
        }
    }
}

ColumnMatrix saddleMatrix(const ColumnMatrix& gradient, const ColumnMatrix& trace, double scale) {
    const Eigen::Index n = gradient.rows(), m = trace.rows();
    std::vector<Eigen::Triplet<double>> entries;
    append(gradient, 0, 0, scale, entries);
    append(trace, n, 0, 1, entries);
    append(trace.transpose(), 0, n, 1, entries);
    ColumnMatrix matrix(n + m, n + m);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace

GradientExtension::GradientExtension(const RowSparseMatrix& mass, const RowSparseMatrix& gradient)
    : n_(mass.rows()) {
    if (gradient.nonZeros() == 0) {
        throw SolverError("there is no gradient term on this interface: it has no trimmed "
                          "patch and no edge of one; choose the minimum norm solution");
    }
    active_ = rowsOfEither(mass, gradient);
    trace_.compute(restricted(mass, active_));
    if (trace_.info() != Eigen::Success) {
        throw SolverError("the QR decomposition of the mass matrix failed (SPQR)");
    }
    rank_ = trace_.rank();
    const ColumnMatrix term = restricted(gradient, active_);
    const ColumnMatrix rows = traceRows();
    scale_ = largest(rows) / largest(term); // both blocks of one size, so that pivots compare
    saddle_ = saddleMatrix(term, rows, scale_);
    factors_.compute(saddle_);
    if (factors_.info() != Eigen::Success) {
        throw SolverError("the gradient term leaves values on the interface open: "
                          "choose the minimum norm solution");
    }
}

GradientExtension::ColumnMatrix GradientExtension::traceRows() const {
    const ColumnMatrix permuted = ColumnMatrix(trace_.matrixR()).topRows(rank_);
    const auto columns = trace_.colsPermutation();
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < permuted.outerSize(); ++j) {
        for (ColumnMatrix::InnerIterator entry(permuted, j); entry; ++entry) {
            entries.emplace_back(static_cast<int>(entry.row()),
                                 static_cast<int>(columns.indices()[j]), entry.value());
        }
    }
    ColumnMatrix rows(rank_, permuted.cols());
    rows.setFromTriplets(entries.begin(), entries.end());
    return rows;
}

Eigen::MatrixXd GradientExtension::solve(const Eigen::MatrixXd& rhs,
                                         const Eigen::MatrixXd& slopes) const {
    const Eigen::Index n = static_cast<Eigen::Index>(active_.size());
    const Eigen::MatrixXd reduced = rhs(active_, Eigen::all);
    const Eigen::MatrixXd projected = trace_.matrixQ().transpose() * reduced;
    Eigen::MatrixXd saddleRhs = Eigen::MatrixXd::Zero(n + rank_, rhs.cols());
    saddleRhs.topRows(n) = scale_ * slopes(active_, Eigen::all);
    saddleRhs.bottomRows(rank_) = projected.topRows(rank_);
    Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(n_, rhs.cols());
    const Eigen::MatrixXd solved = factors_.solve(saddleRhs);
    solution(active_, Eigen::all) = solved.topRows(n);
    return solution;
}

TransposedSolution GradientExtension::solveTransposed(const Eigen::MatrixXd& rhs) const {
    const Eigen::Index n = static_cast<Eigen::Index>(active_.size());
    Eigen::MatrixXd saddleRhs = Eigen::MatrixXd::Zero(n + rank_, rhs.cols());
    saddleRhs.topRows(n) = rhs(active_, Eigen::all);
    const Eigen::MatrixXd solved = factors_.solve(saddleRhs);
    Eigen::MatrixXd multipliers = Eigen::MatrixXd::Zero(n, rhs.cols());
    multipliers.topRows(rank_) = solved.bottomRows(rank_);
    const Eigen::MatrixXd rotated = trace_.matrixQ() * multipliers;
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(n_, rhs.cols());
    TransposedSolution solution{zero, zero};
    solution.trace(active_, Eigen::all) = rotated;
    solution.slopes(active_, Eigen::all) = scale_ * solved.topRows(n);
    return solution;
}

} // namespace tokay::mapper
