// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/history/LowRankMatrix.hpp"

#include "common/dense/SingularValues.hpp"
#include "common/dense/ThinQr.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>

namespace tokay::coupling {
namespace {

void appendColumns(Eigen::MatrixXd& matrix, const Eigen::MatrixXd& columns) {
    matrix.conservativeResize(columns.rows(), matrix.cols() + columns.cols());
    matrix.rightCols(columns.cols()) = columns;
}

} // namespace

void LowRankMatrix::append(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
    assert(A.cols() == B.cols());
    assert(rank() == 0 || (A.rows() == A_.rows() && B.rows() == B_.rows()));
    const Eigen::Index first = rank();
    appendColumns(A_, A);
    appendColumns(B_, B);
    markColumnsFrom(first);
}

void LowRankMatrix::truncate(int rank) {
    assert(rank >= 0 && rank <= this->rank());
    A_.conservativeResize(Eigen::NoChange, rank);
    B_.conservativeResize(Eigen::NoChange, rank);
    columnMarks_.resize(static_cast<std::size_t>(rank));
}

void LowRankMatrix::scale(double factor) {
    A_ *= factor;
    markColumnsFrom(0);
}

void LowRankMatrix::markColumnsFrom(Eigen::Index first) {
    static std::atomic<std::uint64_t> lastMark{0};
    columnMarks_.resize(static_cast<std::size_t>(first));
    for (Eigen::Index k = first; k < A_.cols(); ++k) {
        columnMarks_.push_back(++lastMark);
    }
}

void LowRankMatrix::compress(int maxRank, double relativeLimit) {
    if (rank() == 0) {
        return;
    }
    const ThinQr a(A_);
    const ThinQr b(B_);
    const SingularValues svd(a.R * b.R.transpose());
    const Eigen::Index n = std::min<Eigen::Index>(maxRank, svd.rank(relativeLimit));
    A_ = a.Q * svd.U.leftCols(n) * svd.values.head(n).asDiagonal();
    B_ = b.Q * svd.V.leftCols(n);
    markColumnsFrom(0);
}

void LowRankMatrix::limitRank(const RankOptions& options) {
    const auto full = static_cast<int>(std::min(A_.rows(), B_.rows()));
    if (rank() > std::min(options.maxRank, 2 * full)) {
        compress(options.maxRank / 2, options.rankLimit);
    }
}

void LowRankMatrix::save(StateWriter& state) const {
    state.matrix(A_);
    state.matrix(B_);
}

void LowRankMatrix::restore(StateReader& state, Rows rows) {
    A_ = rows == Rows::ofInterface ? state.interfaceMatrix() : state.matrix();
    B_ = state.interfaceMatrix();
    if (A_.cols() != B_.cols()) {
        throw channel::PeerError("the factors of a Jacobian do not fit each other");
    }
    markColumnsFrom(0);
}

Eigen::VectorXd LowRankMatrix::apply(const Eigen::VectorXd& v, Eigen::Index nRows) const {
    // Newton's method starts where nothing has moved; on a large interface a product is dear
    if (rank() == 0 || v.isZero(0)) {
        return Eigen::VectorXd::Zero(nRows);
    }
    return A_ * (B_.transpose() * v);
}

} // namespace tokay::coupling
