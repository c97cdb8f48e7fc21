// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include "igaStructure/timeIntegration/supportRates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

// Sum of matrices of one sparsity: target = a A + b B.
void combine(double a, const SparseMatrix& A, double b, const SparseMatrix& B,
             SparseMatrix& target) {
    assert(A.nonZeros() == B.nonZeros());
    if (target.nonZeros() != A.nonZeros()) {
        target = A;
    }
    const Eigen::Index n = A.nonZeros();
    Eigen::Map<VectorXd>(target.valuePtr(), n) = a * Eigen::Map<const VectorXd>(A.valuePtr(), n) +
                                                 b * Eigen::Map<const VectorXd>(B.valuePtr(), n);
}

// Times of the fluid come with rounding errors, which are no new time step.
bool isSameTimeStep(double one, double other) {
    return std::abs(one - other) <= 1e-12 * one;
}

} // namespace

TimeIntegrator::TimeIntegrator(StructuralModel& model, const TimeScheme& scheme,
                               const NewtonOptions& newton, double startTime)
    : model_(model), scheme_(scheme), newton_(newton), mass_(model.massMatrix()),
      stiffness_(stiffnessAtRest(model)),
      solver_(makeLinearSolver(mass_, model.fixed(),
                               model.hasSymmetricTangent() ? MatrixKind::positiveDefinite
                                                           : MatrixKind::general,
                               model.extension())),
      internalRounding_(stiffness_, model.size()), inertiaRounding_(roundingOf(mass_)) {
    state_.time = startTime;
    state_.displacement = VectorXd::Zero(model.nUnknowns());
    state_.velocity = state_.displacement;
    state_.acceleration = state_.displacement;
    state_.force = model.externalForce(startTime);
    followerForce_ = followerForce(state_.displacement, startTime);
    startShift_ = endShift_ = model.supportShift(startTime);
    if (scheme.dynamic) {
        requireSupportsAtRest(model, startTime);
        setInitialAcceleration(VectorXd::Zero(model.nUnknowns()));
    } else if (!model.freeRigidMotions().empty()) {
        throw SolverError("a static analysis needs supports against every rigid motion" +
                          freeMotionsHint());
    }
    state_.reaction = initialReaction();
}

// @param ofSupports  acceleration, 0 at free unknowns
void TimeIntegrator::setInitialAcceleration(const VectorXd& ofSupports) {
    solver_->factorise(mass_);
    ++nFactorisations_;
    state_.acceleration = ofSupports;
    state_.acceleration -= solver_->solve(imbalanceAtStart());
}

// But for internal forces, that is, for a prestress.
VectorXd TimeIntegrator::imbalanceAtStart() const {
    return mass_ * state_.acceleration + dampingForce(state_.velocity) - state_.force -
           followerForce_;
}

VectorXd TimeIntegrator::initialReaction() const {
    VectorXd force = imbalanceAtStart();
    if (!model_.isLinear()) {
        force += model_.internalForce(state_.displacement).force;
    }
    startShift_.addTo(force);
    return fixedPart(model_.fixed(), std::move(force));
}

void TimeIntegrator::startSupports(double deltaT) {
    if (!isAtStart_) {
        return;
    }
    isAtStart_ = false;
    if (!scheme_.dynamic || !model_.hasPrescribedMotion()) {
        return;
    }
    constexpr double part = 0.03; // differences are exact to digits, and far from rounding
    const SupportRates rates = supportRates(model_, state_.time, part * deltaT);
    state_.velocity = rates.velocity;
    setInitialAcceleration(rates.acceleration);
    state_.reaction = initialReaction();
    energies_.kinetic = 0.5 * state_.velocity.dot(mass_ * state_.velocity);
    energies_.externalWork = energies_.kinetic;
}

void TimeIntegrator::beginTimeStep(double time, double deltaT) {
    assert(deltaT > 0);
    startSupports(deltaT);
    time_ = time;
    deltaT_ = deltaT;
    displacement_ = state_.displacement;
    reaction_.resize(0);
    if (scheme_.dynamic && !isSameTimeStep(deltaT_, resistedDeltaT_)) {
        resistInertia();
    }
}

// Springs of weak supports and joints are stiff compared with what is solved in this step.
void TimeIntegrator::resistInertia() {
    resistedDeltaT_ = deltaT_;
    if (!model_.resistInertia(massFactor())) {
        return;
    }
    stiffness_ = stiffnessAtRest(model_);
    internalRounding_ = {stiffness_, model_.size()};
    startShift_ = model_.supportShift(state_.time);
    factoredDeltaT_ = 0;
    dropTangent();
}

// Of inertia in the balance, over the displacement at the middle of the step.
double TimeIntegrator::massFactor() const {
    return (1 - scheme_.alphaM) / ((1 - scheme_.alphaF) * scheme_.beta * deltaT_ * deltaT_);
}

const VectorXd& TimeIntegrator::solve(const VectorXd& interfaceForce) {
    setLoads();
    if (interfaceForce.size() > 0) {
        force_ += interfaceForce;
    }
    if (!force_.allFinite()) {
        throw SolverError(
            fmt::format("a force on the structure is not finite at time {:.6g} s", time_));
    }
    residuals_.clear();
    do {
        if (model_.isLinear()) {
            solveLinear();
        } else {
            solveNonlinear();
        }
    } while (!model_.settlePrescribed(displacement_));
    return displacement_;
}

// The model's own, and where its supports are.
void TimeIntegrator::setLoads() {
    force_ = model_.externalForce(time_);
    endShift_ = model_.supportShift(time_);
}

// Forces at the end of the step enter the balance with the factor 1 - alphaF.
VectorXd TimeIntegrator::requiredForce(const VectorXd& displacement) {
    setLoads();
    return balance(asSupported(model_, displacement, time_)).residual / (scheme_.alphaF - 1);
}

void TimeIntegrator::linearise(const VectorXd& displacement) {
    displacement_ = asSupported(model_, displacement, time_);
    reaction_.resize(0);
    linearisedAt_.reset();
    if (!model_.isLinear()) {
        renewTangent();
    } else if (!isFactoredForStep()) {
        tangent_ = stiffness_;
        factorise();
    }
    tangentServes_ = true;
}

double TimeIntegrator::reuseContraction() const {
    return tangentServes_ && isFactoredForStep() ? newton_.reuseContraction : 0;
}

Eigen::MatrixXd TimeIntegrator::responses(const Eigen::MatrixXd& forces) {
    return (1 - scheme_.alphaF) * solver_->solveAll(forces);
}

// Reactions enter the balance as other forces do, old ones with the factor alphaF.
VectorXd TimeIntegrator::reaction() const {
    const VectorXd inBalance = reaction_.size() > 0 ? reaction_ : balance(displacement_).reaction;
    return (inBalance - scheme_.alphaF * state_.reaction) / (1 - scheme_.alphaF);
}

void TimeIntegrator::acceptTimeStep() {
    MotionState next;
    next.time = time_;
    next.displacement = displacement_;
    next.acceleration = accelerationFor(displacement_);
    next.velocity = velocityFor(next.acceleration);
    next.force = force_;
    next.reaction = reaction();
    updateEnergies(next);
    state_ = std::move(next);
}

void TimeIntegrator::rejectTimeStep() {
    displacement_ = state_.displacement;
    dropTangent();
}

void TimeIntegrator::goBack(const MotionState& state, const Energies& energies) {
    assert(state.displacement.size() == model_.nUnknowns());
    isAtStart_ = false;
    state_ = state;
    energies_ = energies;
    followerForce_ = followerForce(state_.displacement, state_.time);
    startShift_ = model_.supportShift(state_.time);
    displacement_ = state_.displacement;
}

void TimeIntegrator::restore(const MotionState& state, const Energies& energies) {
    goBack(state, energies);
    dropTangent();
}

VectorXd TimeIntegrator::accelerationFor(const VectorXd& displacement) const {
    if (!scheme_.dynamic) {
        return VectorXd::Zero(displacement.size());
    }
    return (displacement - state_.displacement - deltaT_ * state_.velocity) /
               (scheme_.beta * deltaT_ * deltaT_) -
           (0.5 / scheme_.beta - 1) * state_.acceleration;
}

VectorXd TimeIntegrator::velocityFor(const VectorXd& acceleration) const {
    return state_.velocity +
           deltaT_ * ((1 - scheme_.gamma) * state_.acceleration + scheme_.gamma * acceleration);
}

VectorXd TimeIntegrator::dampingForce(const VectorXd& velocity) const {
    VectorXd force = VectorXd::Zero(velocity.size());
    if (model_.massDamping() > 0) {
        force += model_.massDamping() * (mass_ * velocity);
    }
    if (model_.stiffnessDamping() > 0) {
        force += model_.stiffnessDamping() * (stiffness_ * velocity);
    }
    return force;
}

VectorXd TimeIntegrator::atAlphaF(const VectorXd& start, const VectorXd& end) const {
    return (1 - scheme_.alphaF) * end + scheme_.alphaF * start;
}

double TimeIntegrator::middleTime() const {
    return time_ - scheme_.alphaF * deltaT_;
}

VectorXd TimeIntegrator::followerForce(const VectorXd& displacement, double time) const {
    VectorXd force = VectorXd::Zero(displacement.size());
    model_.addFollowerForce(displacement, time, force);
    return force;
}

StructuralModel::Internal TimeIntegrator::internalForce(const VectorXd& middle) const {
    StructuralModel::Internal internal;
    if (model_.isLinear()) {
        internal.force = stiffness_ * middle;
    } else {
        internal = model_.internalForce(middle);
    }
    if (endShift_.force.size() > 0) {
        internal.force += atAlphaF(startShift_.force, endShift_.force);
    }
    return internal;
}

TimeIntegrator::Balance TimeIntegrator::balance(const VectorXd& displacement) const {
    const VectorXd middle = atAlphaF(state_.displacement, displacement);
    const StructuralModel::Internal internal = internalForce(middle);
    Balance balance;
    // An iteration that has run away is not at its rounding error.
    constexpr double farAway = 100;
    const bool isLost =
        !scheme_.dynamic && middle.lpNorm<Eigen::Infinity>() > farAway * model_.size();
    balance.rounding = isLost ? 0 : internalRounding_.at(middle);
    balance.smallestVolumeRatio = internal.smallestVolumeRatio;
    const VectorXd external = atAlphaF(state_.force, force_) + followerForce(middle, middleTime());
    balance.residual = external - internal.force;
    // Reactions at supports are in balance too, so the norms are of whole vectors.
    balance.scale = std::max({external.norm(), internal.force.norm(), balance.rounding});
    if (scheme_.dynamic) {
        const VectorXd acceleration = accelerationFor(displacement);
        const VectorXd inertia =
            mass_ * ((1 - scheme_.alphaM) * acceleration + scheme_.alphaM * state_.acceleration);
        balance.residual -= inertia;
        balance.residual -= dampingForce(atAlphaF(state_.velocity, velocityFor(acceleration)));
        balance.scale = std::max(balance.scale, inertia.norm());
        // Accelerations are differences of displacements over the time step squared.
        balance.rounding += inertiaRounding_ * displacement.lpNorm<Eigen::Infinity>() /
                            (scheme_.beta * deltaT_ * deltaT_);
    }
    balance.reaction = fixedPart(model_.fixed(), -balance.residual);
    setFixedToZero(model_.fixed(), balance.residual);
    return balance;
}

// tangent_ holds the tangent of the internal force and gets that of the balance.
void TimeIntegrator::factorise() {
    const double internalFactor = 1 - scheme_.alphaF;
    if (scheme_.dynamic) {
        const double velocityFactor =
            (1 - scheme_.alphaF) * scheme_.gamma / (scheme_.beta * deltaT_);
        const double inertiaFactor =
            internalFactor * massFactor() + velocityFactor * model_.massDamping();
        combine(internalFactor, tangent_, inertiaFactor, mass_, tangent_);
        if (model_.stiffnessDamping() > 0) {
            combine(1, tangent_, velocityFactor * model_.stiffnessDamping(), stiffness_, tangent_);
        }
    }
    factoredDeltaT_ = 0;
    tangentServes_ = false;
    try {
        solver_->factorise(tangent_);
    } catch (const NotPositiveDefinite& error) {
        throw SolverError(fmt::format(
            "time {:.6g} s: {} at control point {}, component {}: the structure has no stiffness "
            "or buckles there{}",
            time_, error.what(), error.unknown / model_.nComponents(),
            error.unknown % model_.nComponents(), freeMotionsHint()));
    } catch (const SingularMatrix& error) {
        throw SolverError(fmt::format("time {:.6g} s: {}: the structure has no stiffness in some "
                                      "direction, or buckles{}",
                                      time_, error.what(), freeMotionsHint()));
    }
    ++nFactorisations_;
    factoredDeltaT_ = deltaT_;
}

bool TimeIntegrator::isFactoredForStep() const {
    return factoredDeltaT_ > 0 && (!scheme_.dynamic || isSameTimeStep(deltaT_, factoredDeltaT_));
}

void TimeIntegrator::solveLinear() {
    linearise(displacement_);
    // From the old state: the solution must not depend on earlier solves.
    const VectorXd start = asSupported(model_, state_.displacement, time_);
    displacement_ = start + solver_->solve(balance(start).residual);
    Balance end = balance(displacement_);
    reaction_ = std::move(end.reaction);
    residuals_.push_back(end.residual.norm() / end.scale);
    nIterations_ = 1;
    if (!displacement_.allFinite()) {
        throwNotConverged("the solution is not finite");
    }
}

void TimeIntegrator::renewTangent() {
    const VectorXd middle = atAlphaF(state_.displacement, displacement_);
    if (linearisedAt_ && mixesStresses_) {
        model_.mixedInternalForce(middle, *linearisedAt_, tangent_);
    } else {
        model_.internalForce(middle, tangent_);
    }
    linearisedAt_ = middle;
    model_.subtractFollowerDerivative(middle, middleTime(), tangent_);
    factorise();
}

// Mixed stresses save iterations, but in a very large step they may miss the solution that
// exact tangents find.
void TimeIntegrator::solveNonlinear() {
    mixesStresses_ = newton_.mixedStresses;
    if (!mixesStresses_) {
        findBalance();
        return;
    }
    const VectorXd start = displacement_;
    try {
        findBalance();
    } catch (const SolverError&) {
        const int nInVain = nIterations_;
        mixesStresses_ = false;
        tangentServes_ = false;
        displacement_ = start;
        residuals_.clear();
        findBalance();
        nIterations_ += nInVain;
    }
}

void TimeIntegrator::findBalance() {
    linearisedAt_.reset();
    const VectorXd motion = asSupported(model_, displacement_, time_) - displacement_;
    nIterations_ = 0;
    if (!motion.isZero(0)) {
        moveSupports(motion);
        ++nIterations_;
    }
    Balance current = balance(displacement_);
    for (; nIterations_ < newton_.maxIterations; ++nIterations_) {
        residuals_.push_back(current.residual.norm() / current.scale);
        if (!std::isfinite(residuals_.back())) {
            throwNotConverged("the residual is not finite");
        }
        // No iteration gets below rounding error.
        if (residuals_.back() <= newton_.tolerance || current.residual.norm() <= current.rounding) {
            reaction_ = std::move(current.reaction);
            return;
        }
        Balance next = iterate(current);
        tangentServes_ = next.residual.norm() <= newton_.reuseContraction * current.residual.norm();
        current = std::move(next);
    }
    throwNotConverged("Newton's method did not converge");
}

// The whole structure follows its supports as its tangent has it, without which a layer of
// elements would take all of their motion.
void TimeIntegrator::moveSupports(const VectorXd& motion) {
    const VectorXd residual = balance(displacement_).residual;
    if (!(tangentServes_ && isFactoredForStep())) {
        renewTangent();
    }
    displacement_ += motion + solver_->solve(residual - tangent_ * motion);
}

TimeIntegrator::Balance TimeIntegrator::iterate(const Balance& current) {
    if (tangentServes_ && isFactoredForStep()) {
        if (std::optional<Balance> next = iterateWithKeptTangent(current)) {
            return *std::move(next);
        }
    }
    renewTangent();
    return searchAlong(solver_->solve(current.residual), current);
}

// A whole update, or none if the residual would rise: a search along the
// direction of an old tangent would spend what keeping it saves.
std::optional<TimeIntegrator::Balance>
TimeIntegrator::iterateWithKeptTangent(const Balance& current) {
    const VectorXd end = displacement_ + solver_->solve(current.residual);
    Balance next = balance(end);
    if (!(next.residual.norm() < current.residual.norm() && next.smallestVolumeRatio > 0)) {
        return std::nullopt;
    }
    displacement_ = end;
    linearisedAt_.reset();
    return next;
}

// Moves along an update as far as the residual's work along it falls enough.
// Near the solution that is the whole update, so that convergence stays quadratic.
TimeIntegrator::Balance TimeIntegrator::searchAlong(const VectorXd& update,
                                                    const Balance& current) {
    constexpr double enough = 0.8;
    constexpr double shortest = 1.0 / 64;
    const double work = std::abs(update.dot(current.residual));
    double length = 1;
    Balance next = balance(displacement_ + update);
    while (
        newton_.lineSearch && length > shortest &&
        !(next.smallestVolumeRatio > 0 && std::abs(update.dot(next.residual)) <= enough * work)) {
        length *= 0.5;
        next = balance(displacement_ + length * update);
    }
    displacement_ += length * update;
    return next;
}

void TimeIntegrator::throwNotConverged(const char* why) const {
    throw SolverError(fmt::format(
        "time {:.6g} s, time step {:.6g} s: {} (relative residuals {:.2e}, tolerance {:g}, at most "
        "{} iterations); use a smaller time step or load step, or check loads and material",
        time_, deltaT_, why, fmt::join(residuals_, " "), newton_.tolerance, newton_.maxIterations));
}

std::string TimeIntegrator::freeMotionsHint() const {
    const std::vector<std::string> motions = model_.freeRigidMotions();
    return motions.empty()
               ? ""
               : fmt::format("; nothing prevents: {}; add supports", fmt::join(motions, ", "));
}

void TimeIntegrator::updateEnergies(const MotionState& next) {
    const VectorXd motion = next.displacement - state_.displacement;
    energies_.kinetic = 0.5 * next.velocity.dot(mass_ * next.velocity);
    energies_.strain =
        model_.strainEnergy(next.displacement) + endShift_.energyAt(next.displacement);
    // Of weak supports, whose forces move by as much as they.
    const VectorXd middle = 0.5 * (next.displacement + state_.displacement);
    energies_.externalWork += endShift_.energyAt(middle) - startShift_.energyAt(middle);
    startShift_ = endShift_;
    const VectorXd followerForce = this->followerForce(next.displacement, next.time);
    energies_.externalWork += 0.5 * motion.dot(next.force + state_.force + followerForce +
                                               followerForce_ + next.reaction + state_.reaction);
    followerForce_ = followerForce;
    energies_.dampingWork +=
        0.5 * motion.dot(dampingForce(next.velocity) + dampingForce(state_.velocity));
}

double TimeIntegrator::bytes() const {
    constexpr double perEntry = sizeof(double) + sizeof(int);
    const double nMatrices = 3;
    return solver_->bytes() + nMatrices * perEntry * static_cast<double>(mass_.nonZeros());
}

} // namespace tokay::structure
