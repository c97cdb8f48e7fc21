// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/FixedPointDriver.hpp"

#include "common/errors.hpp"
#include "coupling/StateReader.hpp"
#include "coupling/StateWriter.hpp"

#include <cassert>
#include <cmath>
#include <string>

namespace tokay::coupling {

FixedPointDriver::FixedPointDriver(const CouplingOptions& options, double tolerance,
                                   const Eigen::VectorXd& initial)
    : acceleration_(options.acceleration), criteria_(options, tolerance),
      predictor_(options.extrapolation, initial), accelerator_(makeAccelerator(options)),
      x_(initial), next_(initial) {}

const Eigen::VectorXd& FixedPointDriver::beginTimeStep(double deltaT) {
    deltaT_ = deltaT;
    statistics_ = {};
    criteria_.beginTimeStep();
    if (accelerator_) {
        accelerator_->beginTimeStep();
    }
    x_ = predictor_.predict(deltaT);
    next_ = x_;
    return x_;
}

Iteration FixedPointDriver::iterate(const Eigen::VectorXd& xTilde, double fluidResidual,
                                    const Eigen::VectorXd& forces) {
    assert(deltaT_ > 0 && xTilde.size() == x_.size());
    if (!std::isfinite(fluidResidual)) {
        throw SolverError("the fluid's residual is " + std::to_string(fluidResidual));
    }
    x_ = next_;
    const double residual = criteria_.residual(x_, xTilde, forces);
    if (accelerator_) {
        next_ = accelerator_->next(x_, xTilde, fluidResidual);
    }
    if (statistics_.nExchanges == 0) {
        statistics_.firstResidual = residual;
    }
    ++statistics_.nExchanges;
    statistics_.lastResidual = residual;
    statistics_.converged = residual < criteria_.tolerance();
    statistics_.nColumns = accelerator_ ? accelerator_->nColumns() : 0;
    if (!accelerator_) {
        return {next_, 0, true};
    }
    return {next_, residual, statistics_.converged};
}

double FixedPointDriver::acceptTimeStep(const Eigen::VectorXd& xTilde) {
    assert(deltaT_ > 0 && xTilde.size() == x_.size());
    const double residual = criteria_.displacementResidual(x_, xTilde);
    if (accelerator_) {
        accelerator_->acceptTimeStep();
    }
    predictor_.accept(xTilde, deltaT_);
    deltaT_ = 0;
    return residual;
}

void FixedPointDriver::rejectTimeStep() {
    if (accelerator_) {
        accelerator_->rejectTimeStep();
    }
    deltaT_ = 0;
}

void FixedPointDriver::save(StateWriter& state) const {
    predictor_.save(state);
    state.integer(static_cast<int>(acceleration_));
    if (accelerator_) {
        accelerator_->save(state);
    }
}

void FixedPointDriver::restore(StateReader& state) {
    predictor_.restore(state);
    if (state.integer() == static_cast<int>(acceleration_) && accelerator_) {
        accelerator_->restore(state);
    }
}

} // namespace tokay::coupling
