// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"

#include "igaStructure/timeIntegration/supportRates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

// Power iterations; the estimate comes from below, within 1 % after these.
constexpr int nPowerIterations = 60;

void requireNoStiffnessDamping(const StructuralModel& model) {
    if (model.stiffnessDamping() > 0) {
        throw InputError("material.rayleighDamping.stiffness: explicit time integration has mass "
                         "damping only; set it to 0, or choose another time.scheme");
    }
}

} // namespace

ExplicitIntegrator::ExplicitIntegrator(StructuralModel& model, double startTime)
    : model_(model), mass_(model.lumpedMassMatrix()),
      solver_(
          makeLinearSolver(mass_, model.fixed(), MatrixKind::positiveDefinite, model.extension())) {
    requireNoStiffnessDamping(model);
    requireSupportsAtRest(model, startTime);
    solver_->factorise(mass_);
    state_.time = startTime;
    state_.displacement = VectorXd::Zero(model.nUnknowns());
    state_.velocity = state_.displacement;
    vibration_.resize(model.nUnknowns());
    for (Eigen::Index k = 0; k < vibration_.size(); ++k) {
        vibration_[k] = std::sin(1.0 + 2.9 * static_cast<double>(k)); // has a part of every mode
    }
    totalForce_ = external(startTime);
    shift_ = model.supportShift(startTime);
    state_.force = model.externalForce(startTime);
    setAcceleration(state_.velocity, {});
}

VectorXd ExplicitIntegrator::external(double time) const {
    VectorXd force = model_.externalForce(time);
    model_.addFollowerForce(state_.displacement, time, force);
    return force;
}

// External - damping - internal.
VectorXd ExplicitIntegrator::imbalance(const VectorXd& velocity) const {
    VectorXd internal = model_.internalForce(state_.displacement).force;
    shift_.addTo(internal);
    VectorXd force = totalForce_ - internal;
    if (model_.massDamping() > 0) {
        force -= model_.massDamping() * (mass_ * velocity);
    }
    return force;
}

// Also the reactions to it.
// @param ofSupports  empty: they are at rest
void ExplicitIntegrator::setAcceleration(const VectorXd& velocity, const VectorXd& ofSupports) {
    const VectorXd force = imbalance(velocity);
    if (ofSupports.size() == 0) {
        state_.acceleration = solver_->solve(force);
    } else {
        state_.acceleration = ofSupports + solver_->solve(force - mass_ * ofSupports);
    }
    state_.reaction = fixedPart(model_.fixed(), mass_ * state_.acceleration - force);
}

void ExplicitIntegrator::startSupports(double deltaT) {
    isAtStart_ = false;
    if (!model_.hasPrescribedMotion()) {
        return;
    }
    const SupportRates rates = supportRates(model_, state_.time, deltaT);
    state_.velocity = rates.velocity;
    setAcceleration(state_.velocity, rates.acceleration);
    energies_.externalWork = 0.5 * state_.velocity.dot(mass_ * state_.velocity);
}

double ExplicitIntegrator::stableStep(const VectorXd& displacement) {
    SparseMatrix tangent;
    model_.internalForce(displacement, tangent);
    double square = 0; // of the angular frequency
    for (int k = 0; k < nPowerIterations; ++k) {
        vibration_ /= std::sqrt(vibration_.dot(mass_ * vibration_));
        vibration_ = solver_->solve(tangent * vibration_);
        square = std::sqrt(vibration_.dot(mass_ * vibration_));
    }
    return 2 / std::sqrt(1.01 * square);
}

void ExplicitIntegrator::advancePart(double time, double deltaT) {
    const VectorXd middle = state_.velocity + 0.5 * deltaT * state_.acceleration;
    VectorXd motion = deltaT * middle;
    const VectorXd end = state_.displacement + motion;
    const VectorXd before = totalForce_ + state_.reaction;
    state_.displacement = asSupported(model_, end, time);
    motion += state_.displacement - end;
    state_.time = time;
    totalForce_ = external(time);
    const VectorXd half = state_.displacement - 0.5 * motion;
    energies_.externalWork -= shift_.energyAt(half);
    shift_ = model_.supportShift(time);
    energies_.externalWork += shift_.energyAt(half);
    const SupportRates rates = supportRates(model_, time, -deltaT);
    setAcceleration(middle, rates.acceleration);
    state_.velocity =
        asSupported(model_, middle + 0.5 * deltaT * state_.acceleration, rates.velocity);
    energies_.externalWork += 0.5 * motion.dot(before + totalForce_ + state_.reaction);
    energies_.dampingWork += model_.massDamping() * motion.dot(mass_ * middle);
}

int ExplicitIntegrator::nPartsUntil(double time) {
    const double limit = safety * stableStep(state_.displacement);
    const double nParts = std::ceil((time - state_.time) / limit * (1 - 1e-12));
    if (!(nParts <= std::numeric_limits<int>::max())) {
        throw SolverError(fmt::format(
            "time {:.6g} s: the time step would take {:.3g} parts, stable up to {:.3g} s each: the "
            "motion has grown beyond all bounds, or the structure is too stiff for explicit time "
            "integration; use a smaller time.step, or choose another time.scheme",
            time, nParts, limit));
    }
    return static_cast<int>(nParts);
}

StepEffort ExplicitIntegrator::advance(double time, double /*deltaT*/) {
    const double start = state_.time;
    const int nParts = nPartsUntil(time);
    const double part = (time - start) / nParts;
    if (isAtStart_) {
        startSupports(part);
    }
    for (int k = 1; k <= nParts; ++k) {
        advancePart(k == nParts ? time : start + k * part, part);
    }
    state_.force = model_.externalForce(time);
    energies_.kinetic = 0.5 * state_.velocity.dot(mass_ * state_.velocity);
    energies_.strain =
        model_.strainEnergy(state_.displacement) + shift_.energyAt(state_.displacement);
    if (!state_.displacement.allFinite() || !std::isfinite(energies_.strain)) {
        throw SolverError(fmt::format("time {:.6g} s: the motion is not finite, in {} parts of "
                                      "{:.3g} s each; use a smaller time.step, so that the stable "
                                      "step is estimated more often",
                                      time, nParts, part));
    }
    return {nParts, 0, {}};
}

} // namespace tokay::structure
