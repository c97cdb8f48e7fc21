// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/step/Predictor.hpp"

#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <cassert>

namespace tokay::coupling {

const Choices<Extrapolation>& extrapolations() {
    static const Choices<Extrapolation> choices = {{"constant", Extrapolation::constant},
                                                   {"linear", Extrapolation::linear},
                                                   {"quadratic", Extrapolation::quadratic},
                                                   {"cubic", Extrapolation::cubic}};
    return choices;
}

Predictor::Predictor(Extrapolation extrapolation, const Eigen::VectorXd& initial)
    : nPoints_(static_cast<std::size_t>(extrapolation) + 1), accepted_{{0, initial}} {}

Eigen::VectorXd Predictor::predict(double deltaT) const {
    assert(deltaT > 0);
    const double now = accepted_.front().time + deltaT;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(accepted_.front().x.size());
    for (const Accepted& one : accepted_) {
        double lagrange = 1;
        for (const Accepted& other : accepted_) {
            if (&other != &one) {
                lagrange *= (now - other.time) / (one.time - other.time);
            }
        }
        x += lagrange * one.x;
    }
    return x;
}

void Predictor::accept(const Eigen::VectorXd& x, double deltaT) {
    assert(deltaT > 0);
    accepted_.push_front({accepted_.front().time + deltaT, x});
    if (accepted_.size() > nPoints_) {
        accepted_.pop_back();
    }
}

void Predictor::save(StateWriter& state) const {
    state.integer(static_cast<int>(accepted_.size()));
    for (const Accepted& one : accepted_) {
        state.number(one.time);
        state.matrix(one.x);
    }
}

void Predictor::restore(StateReader& state, Values values) {
    accepted_.clear();
    for (int n = state.integer(); n > 0; --n) {
        const double time = state.number();
        accepted_.push_back(
            {time, values == Values::ofInterface ? state.interfaceVector() : state.vector()});
    }
    while (accepted_.size() > nPoints_) { // fewer are wanted now
        accepted_.pop_back();
    }
}

} // namespace tokay::coupling
