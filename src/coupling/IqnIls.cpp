#include "coupling/IqnIls.hpp"

#include <algorithm>

namespace tokay::coupling {

IqnIls::IqnIls(const CouplingOptions& options)
    : options_(options), V_(options.filter, options.filterLimit) {}

void IqnIls::beginTimeStep() {
    previous_ = {};
    while (!W_.empty() && W_.back().step < step_ - options_.reusedTimeSteps) {
        removeOldest();
    }
}

Eigen::VectorXd IqnIls::next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                             double fluidResidual) {
    const Exchange now{x, xTilde};
    if (previous_.x.size() != 0) {
        learn(now, fluidResidual);
    }
    previous_ = now;
    const Eigen::VectorXd residual = xTilde - x;
    if (W_.empty()) {
        return x + options_.initialRelaxation * residual;
    }
    Eigen::VectorXd move = quasiNewtonStep(now);
    const double longest = options_.largestStep * residual.norm();
    if (longest > 0 && move.norm() > longest) {
        move *= longest / move.norm();
    }
    return x + move;
}

void IqnIls::learn(const Exchange& now, double fluidResidual) {
    const Eigen::VectorXd dx = now.x - previous_.x;
    // A smaller move than the fluid's own error teaches nothing but its drift.
    const double noise = options_.signalToNoise * fluidResidual * now.xTilde.norm();
    if (!(dx.norm() > noise)) {
        return;
    }
    const Eigen::VectorXd w = now.xTilde - previous_.xTilde;
    W_.push_front({w, step_});
    for (const int column : V_.prepend(w - dx)) {
        W_.erase(W_.begin() + column);
    }
    while (nColumns() > options_.largestColumns) {
        removeOldest();
    }
}

Eigen::VectorXd IqnIls::quasiNewtonStep(const Exchange& now) const {
    const Eigen::VectorXd residual = now.xTilde - now.x;
    const Eigen::VectorXd coefficients = V_.solve(-residual);
    Eigen::VectorXd move = residual;
    for (std::size_t i = 0; i < W_.size(); ++i) {
        move += coefficients[static_cast<Eigen::Index>(i)] * W_[i].w;
    }
    return move;
}

void IqnIls::acceptTimeStep() {
    double largest = 0;
    for (const Column& column : W_) {
        if (column.step == step_) {
            largest = std::max(largest, column.w.norm());
        }
    }
    for (int i = nColumns() - 1; i >= 0; --i) {
        const Column& column = W_[static_cast<std::size_t>(i)];
        if (column.step == step_ && column.w.norm() < options_.keepFraction * largest) {
            remove(i);
        }
    }
    ++step_;
}

void IqnIls::rejectTimeStep() {
    while (!W_.empty() && W_.front().step == step_) {
        remove(0);
    }
}

void IqnIls::remove(int column) {
    V_.remove(column);
    W_.erase(W_.begin() + column);
}

void IqnIls::removeOldest() {
    remove(nColumns() - 1);
}

} // namespace tokay::coupling
