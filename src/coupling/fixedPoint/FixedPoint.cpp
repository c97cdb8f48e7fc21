// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fixedPoint/FixedPoint.hpp"

#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <cassert>
#include <cmath>

namespace tokay::coupling {

using Eigen::VectorXd;

FixedPoint::FixedPoint(const CouplingOptions& options, double tolerance,
                       CoupledStructure& structure, std::unique_ptr<Accelerator> accelerator)
    : acceleration_(options.acceleration.type), structure_(structure),
      criteria_(options.convergence, tolerance),
      predictor_(options.predictor, structure.acceptedDisplacements()),
      accelerator_(std::move(accelerator)), x_(structure.acceptedDisplacements()), next_(x_) {}

const VectorXd& FixedPoint::predict(double deltaT) {
    deltaT_ = deltaT;
    statistics_ = {};
    criteria_.beginTimeStep();
    accelerator_->beginTimeStep();
    x_ = predictor_.predict(deltaT);
    next_ = x_;
    return x_;
}

CouplingIteration FixedPoint::iterate(const VectorXd& faceForces,
                                      std::optional<double> fluidResidual) {
    assert(deltaT_ > 0 && std::isfinite(fluidResidual.value_or(0)));
    x_ = next_;
    const VectorXd xTilde = structure_.solve(faceForces);
    const double residual = criteria_.residual(x_, xTilde, faceForces, fluidResidual);
    next_ = accelerator_->next(x_, xTilde, fluidResidual.value_or(0));
    statistics_.add(residual, criteria_.tolerance(), accelerator_->nColumns());
    if (!accelerator_->iterates()) {
        return {next_, 0, true};
    }
    return {next_, residual, statistics_.converged};
}

CouplingIteration FixedPoint::accept(const VectorXd& finalForces, double limit) {
    assert(deltaT_ > 0);
    const VectorXd xTilde = structure_.solve(finalForces);
    const double residual =
        accelerator_->iterates() ? criteria_.finalResidual(x_, xTilde, finalForces) : 0;
    if (!(residual < limit)) {
        next_ = x_; // where the fluid has stayed
        return {x_, residual, false};
    }
    accelerator_->acceptTimeStep();
    predictor_.accept(xTilde, deltaT_);
    criteria_.acceptTimeStep(finalForces);
    deltaT_ = 0;
    return {xTilde, residual, true};
}

void FixedPoint::reject() {
    accelerator_->rejectTimeStep();
    deltaT_ = 0;
}

void FixedPoint::save(StateWriter& state) const {
    predictor_.save(state);
    criteria_.save(state);
    state.text(acceleration_);
    accelerator_->save(state);
}

void FixedPoint::restore(StateReader& state) {
    predictor_.restore(state);
    criteria_.restore(state);
    if (state.text() == acceleration_) {
        accelerator_->restore(state);
    }
}

} // namespace tokay::coupling
