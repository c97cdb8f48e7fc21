// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fixedPoint/IqnIls.hpp"

#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <algorithm>

namespace tokay::coupling {

const SchemaOf<IqnIls::Options>& IqnIls::Options::schema() {
    static const SchemaOf<Options> schema =
        SchemaOf<Options>{{"reusedTimeSteps", &Options::reusedTimeSteps, "[0, inf)", "",
                           "Number of earlier time steps whose differences are used."},
                          {"maxColumns", &Options::maxColumns, "[1, inf)", "",
                           "Maximum number of differences, the newest ones."}}
            .with(QuasiNewtonOptions::schema());
    return schema;
}

IqnIls::IqnIls(const Options& options)
    : QuasiNewton(options), options_(options), model_{FilteredQr(options), {}},
      modelAtBegin_(model_) {}

void IqnIls::beginTimeStep() {
    QuasiNewton::beginTimeStep();
    while (!model_.W.empty() && model_.W.back().step < step_ - options_.reusedTimeSteps) {
        model_.removeOldest();
    }
    modelAtBegin_ = model_;
}

void IqnIls::learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w) {
    model_.W.push_front({w, step_});
    for (const int column : model_.V.prepend(v)) {
        model_.W.erase(model_.W.begin() + column);
    }
    while (nColumns() > options_.maxColumns) {
        model_.removeOldest();
    }
}

Eigen::VectorXd IqnIls::response(const Eigen::VectorXd& residual) const {
    const Eigen::VectorXd coefficients = model_.V.solve(residual);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(residual.size());
    for (std::size_t i = 0; i < model_.W.size(); ++i) {
        result += coefficients[static_cast<Eigen::Index>(i)] * model_.W[i].w;
    }
    return result;
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

void IqnIls::save(StateWriter& state) const {
    state.integer(step_);
    model_.V.save(state);
    for (const Column& column : model_.W) {
        state.integer(column.step);
        state.matrix(column.w);
    }
}

void IqnIls::restore(StateReader& state) {
    step_ = state.integer();
    model_.V.restore(state);
    model_.W.clear();
    for (int i = 0; i < nColumns(); ++i) {
        const int step = state.integer();
        model_.W.push_back({state.interfaceVector(), step});
    }
}

void IqnIls::Model::remove(int column) {
    V.remove(column);
    W.erase(W.begin() + column);
}

} // namespace tokay::coupling
