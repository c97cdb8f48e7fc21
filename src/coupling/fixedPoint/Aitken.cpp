// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fixedPoint/Aitken.hpp"

#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <algorithm>

namespace tokay::coupling {

Aitken::Aitken(const CouplingOptions& options)
    : initial_(options.initialRelaxation), smallest_(options.smallestRelaxation),
      largest_(options.largestRelaxation), relaxation_(options.initialRelaxation) {}

void Aitken::beginTimeStep() {
    previousResidual_.resize(0);
    previousX_.resize(0);
    // The last factor of the last step, unless it was bolder than the first.
    relaxation_ = std::min(relaxation_, initial_);
}

Eigen::VectorXd Aitken::next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                             double /*fluidResidual*/) {
    const Eigen::VectorXd residual = xTilde - x;
    if (previousResidual_.size() != 0 && previousX_ != x) {
        updateRelaxation(residual);
    }
    previousResidual_ = residual;
    previousX_ = x;
    return x + relaxation_ * residual;
}

void Aitken::updateRelaxation(const Eigen::VectorXd& residual) {
    const Eigen::VectorXd change = residual - previousResidual_;
    const double squaredChange = change.squaredNorm();
    if (squaredChange == 0) {
        return;
    }
    const double proposed = -relaxation_ * previousResidual_.dot(change) / squaredChange;
    relaxation_ = std::clamp(proposed, smallest_, largest_);
}

void Aitken::rejectTimeStep() {
    relaxation_ = initial_;
}

void Aitken::save(StateWriter& state) const {
    state.number(relaxation_);
}

void Aitken::restore(StateReader& state) {
    relaxation_ = state.number();
}

} // namespace tokay::coupling
