#include "coupling/IqnIls.hpp"

#include <algorithm>

namespace tokay::coupling {

IqnIls::IqnIls(const CouplingOptions& options)
    : options_(options), model_{FilteredQr(options.filter, options.filterLimit), {}},
      modelAtBegin_(model_) {}

void IqnIls::beginTimeStep() {
    previous_ = {};
    while (!model_.W.empty() && model_.W.back().step < step_ - options_.reusedTimeSteps) {
        model_.removeOldest();
    }
    modelAtBegin_ = model_;
}

Eigen::VectorXd IqnIls::next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                             double fluidResidual) {
    const Exchange now{x, xTilde};
    if (previous_.x.size() != 0) {
        learn(now, fluidResidual);
    }
    previous_ = now;
    const Eigen::VectorXd residual = xTilde - x;
    if (model_.W.empty()) {
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
    model_.W.push_front({w, step_});
    for (const int column : model_.V.prepend(w - dx)) {
        model_.W.erase(model_.W.begin() + column);
    }
    while (nColumns() > options_.largestColumns) {
        model_.removeOldest();
    }
}

Eigen::VectorXd IqnIls::quasiNewtonStep(const Exchange& now) const {
    const Eigen::VectorXd residual = now.xTilde - now.x;
    const Eigen::VectorXd coefficients = model_.V.solve(-residual);
    Eigen::VectorXd move = residual;
    for (std::size_t i = 0; i < model_.W.size(); ++i) {
        move += coefficients[static_cast<Eigen::Index>(i)] * model_.W[i].w;
    }
    return move;
}

void IqnIls::acceptTimeStep() {
    double largest = 0;
    for (const Column& column : model_.W) {
        if (column.step == step_) {
            largest = std::max(largest, column.w.norm());
        }
    }
    for (int i = nColumns() - 1; i >= 0; --i) {
        const Column& column = model_.W[static_cast<std::size_t>(i)];
        if (column.step == step_ && column.w.norm() < options_.keepFraction * largest) {
            model_.remove(i);
        }
    }
    ++step_;
}

void IqnIls::rejectTimeStep() {
    model_ = modelAtBegin_;
}

void IqnIls::Model::remove(int column) {
    V.remove(column);
    W.erase(W.begin() + column);
}

} // namespace tokay::coupling
