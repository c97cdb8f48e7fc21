// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fixedPoint/MultiVectorModel.hpp"

#include <algorithm>

namespace tokay::coupling {

MultiVectorModel::MultiVectorModel(const MultiVectorOptions& options)
    : options_(options), V_(options) {}

void MultiVectorModel::learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w) {
    columns_.push_front({w - old_.apply(v, w.size()), w.norm()});
    for (const int column : V_.prepend(v)) {
        columns_.erase(columns_.begin() + column);
    }
}

Eigen::VectorXd MultiVectorModel::apply(const Eigen::VectorXd& v, Eigen::Index nRows) const {
    Eigen::VectorXd result = old_.apply(v, nRows);
    const Eigen::VectorXd coefficients = V_.solve(v);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        result += coefficients[static_cast<Eigen::Index>(i)] * columns_[i].correction;
    }
    return result;
}

/// (W - Jₙ V) R⁻¹ Qᵀ
LowRankMatrix MultiVectorModel::update() const {
    LowRankMatrix result;
    if (columns_.empty()) {
        return result;
    }
    Eigen::MatrixXd corrections(columns_.front().correction.size(), nColumns());
    Eigen::MatrixXd Q(V_.q().front().size(), nColumns());
    for (int i = 0; i < nColumns(); ++i) {
        corrections.col(i) = columns_[static_cast<std::size_t>(i)].correction;
        Q.col(i) = V_.q()[static_cast<std::size_t>(i)];
    }
    V_.r().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(corrections);
    result.append(corrections, Q);
    return result;
}

LowRankMatrix MultiVectorModel::matrix() const {
    LowRankMatrix result = old_;
    const LowRankMatrix added = update();
    if (added.rank() > 0) {
        result.append(added.A(), added.B());
    }
    return result;
}

void MultiVectorModel::acceptTimeStep() {
    double largest = 0;
    for (const Column& column : columns_) {
        largest = std::max(largest, column.norm);
    }
    for (int i = nColumns() - 1; i >= 0; --i) {
        const auto column = columns_.begin() + i;
        if (column->norm < options_.keepFraction * largest) {
            V_.remove(i);
            columns_.erase(column);
        }
    }
    old_ = matrix();
    old_.limitRank(options_);
    rejectTimeStep();
}

void MultiVectorModel::rejectTimeStep() {
    V_.clear();
    columns_.clear();
}

} // namespace tokay::coupling
