// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/SubsteppedIntegrator.hpp"

#include <cassert>

namespace tokay::structure {

using Eigen::VectorXd;

SubsteppedIntegrator::SubsteppedIntegrator(StructuralModel& model, const TimeScheme& scheme,
                                           const NewtonOptions& newton, double startTime,
                                           int nSubsteps)
    : model_(model), integrator_(model, scheme, newton, startTime), nSubsteps_(nSubsteps) {
    assert(nSubsteps == 1 || (nSubsteps > 1 && scheme.dynamic));
    if (nSubsteps > 1) {
        mass_ = model.massMatrix();
        massSolver_ =
            makeLinearSolver(mass_, model.fixed(), MatrixKind::positiveDefinite, model.extension());
        massSolver_->factorise(mass_);
    }
}

void SubsteppedIntegrator::beginTimeStep(double time, double deltaT) {
    if (nSubsteps_ == 1) {
        integrator_.beginTimeStep(time, deltaT);
        return;
    }
    time_ = time;
    deltaT_ = deltaT;
    integrator_.startSupports(deltaT / nSubsteps_);
    start_ = integrator_.state();
    startEnergies_ = integrator_.energies();
    startForce_ = start_.force - model_.externalForce(start_.time);
    isUnderWay_ = true;
    iterates_.clear();
}

const VectorXd& SubsteppedIntegrator::solve(const VectorXd& interfaceForce) {
    if (nSubsteps_ == 1) {
        integrator_.solve(interfaceForce);
        nIterations_ = integrator_.nIterations();
        return integrator_.displacement();
    }
    halfChange_ = 0.5 * (interfaceForce - startForce_);
    const VectorXd mean = startForce_ + halfChange_;
    integrator_.goBack(afterJump(start_, halfChange_), startEnergies_);
    iterates_.resize(static_cast<std::size_t>(nSubsteps_));
    nIterations_ = 0;
    for (int k = 1; k <= nSubsteps_; ++k) {
        VectorXd& iterate = iterates_[static_cast<std::size_t>(k - 1)];
        const double rest = 1 - static_cast<double>(k) / nSubsteps_;
        integrator_.beginTimeStep(time_ - rest * deltaT_, deltaT_ / nSubsteps_);
        if (iterate.size() > 0) {
            integrator_.startFrom(iterate);
        }
        iterate = integrator_.solve(mean);
        nIterations_ += integrator_.nIterations();
        if (k < nSubsteps_) {
            integrator_.acceptTimeStep();
        }
    }
    return integrator_.displacement();
}

// The state under a force that differs from here on: bodies of mass answer at once.
MotionState SubsteppedIntegrator::afterJump(MotionState state, const VectorXd& forceChange) {
    const VectorXd change = massSolver_->solve(forceChange);
    state.acceleration += change;
    state.force += forceChange;
    state.reaction += fixedPart(model_.fixed(), mass_ * change - forceChange);
    return state;
}

void SubsteppedIntegrator::acceptTimeStep() {
    integrator_.acceptTimeStep();
    if (isUnderWay_) {
        integrator_.goBack(afterJump(integrator_.state(), halfChange_), integrator_.energies());
        isUnderWay_ = false;
    }
}

void SubsteppedIntegrator::rejectTimeStep() {
    if (isUnderWay_) {
        integrator_.goBack(start_, startEnergies_);
        isUnderWay_ = false;
    }
    integrator_.rejectTimeStep();
}

void SubsteppedIntegrator::restore(const MotionState& state, const Energies& energies) {
    integrator_.restore(state, energies);
}

TimeIntegrator& SubsteppedIntegrator::singleStep() {
    assert(nSubsteps_ == 1);
    return integrator_;
}

} // namespace tokay::structure
