// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/ArcLength.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

// Iterations a step that arcs are chosen for: Newton's method squares the residual in each,
// and two of them leave too little of an arc's direction to trust.
constexpr double wantedIterations = 5;
constexpr double shortest = 1e-4;
// Turns between the tangent at the start of a step and its chord: 60 degrees.
constexpr double leastCosine = 0.5;
// An iterate so many arcs away has lost the path, as has one at so many times the farthest
// time that the path has seen.
constexpr double farAway = 10;
constexpr double farInTime = 2;
constexpr double arcTolerance = 1e-6;

} // namespace

ArcLength::ArcLength(StructuralModel& model, const NewtonOptions& newton,
                     const EquilibriumPath& path, double firstStep, double end)
    : model_(model), newton_(newton), path_(path), firstStep_(firstStep), end_(end),
      rounding_(stiffnessAtRest(model), model.size()), farthestTime_(end) {
    solver_ = makeLinearSolver(stiffnessAtRest(model), model.fixed(), MatrixKind::general,
                               model.extension());
    MotionState start;
    start.displacement = VectorXd::Zero(model.nUnknowns());
    start.velocity = start.acceleration = start.displacement;
    start.force = model.externalForce(0);
    restart(start);
}

void ArcLength::restart(const MotionState& state) {
    state_ = state;
    totalForce_ = forceAndReaction({state_.displacement, state_.time});
    firstArc_ = arc_ = 0;
}

VectorXd ArcLength::force(const Iterate& at) const {
    VectorXd force = model_.externalForce(at.time);
    model_.addFollowerForce(at.displacement, at.time, force);
    return force;
}

StructuralModel::Internal ArcLength::internalForce(const Iterate& at) const {
    StructuralModel::Internal internal = model_.internalForce(at.displacement);
    model_.supportShift(at.time).addTo(internal.force);
    return internal;
}

// What is out of balance, reactions being those that fixed unknowns leave.
VectorXd ArcLength::forceAndReaction(const Iterate& at) {
    const VectorXd force = this->force(at);
    state_.reaction = fixedPart(model_.fixed(), internalForce(at).force - force);
    return force + state_.reaction;
}

// Formulas are smooth in time, most of them linear: then differences are exact. They stay
// within the times of the run, where formulas are defined.
ArcLength::Rates ArcLength::ratesInTime(const Iterate& at) const {
    const double h = 1e-4 * firstStep_;
    const auto within = [&](double time) {
        return at.time >= 0 && at.time <= end_ ? std::clamp(time, 0.0, end_) : time;
    };
    const double before = within(at.time - h);
    const double after = within(at.time + h);
    const double between = after - before;
    VectorXd change = force({at.displacement, after}) - force({at.displacement, before});
    const StructuralModel::SupportShift shift = model_.supportShift(before);
    if (shift.force.size() > 0) {
        change -= model_.supportShift(after).force - shift.force;
    }
    return {change / between, (model_.prescribed(after) - model_.prescribed(before)) / between};
}

// Of the equilibrium, in time, with the factored tangent.
VectorXd ArcLength::rate(const Iterate& at) const {
    const Rates rates = ratesInTime(at);
    return rates.supports + solver_->solve(rates.force - tangent_ * rates.supports);
}

void ArcLength::factorise(const Iterate& at, const VectorXd* linearisedAt) {
    if (linearisedAt && newton_.mixedStresses) {
        model_.mixedInternalForce(at.displacement, *linearisedAt, tangent_);
    } else {
        model_.internalForce(at.displacement, tangent_);
    }
    model_.subtractFollowerDerivative(at.displacement, at.time, tangent_);
    solver_->factorise(tangent_);
    ++nSolutions_;
}

ArcLength::Iterate ArcLength::predict() {
    const Iterate start{state_.displacement, state_.time};
    factorise(start, nullptr);
    const VectorXd rate = this->rate(start);
    if (!(rate.norm() > 0)) {
        throw SolverError(
            "neither loads nor supports change with time, so there is no path to follow; give "
            "them a factor t");
    }
    if (firstArc_ == 0) {
        firstArc_ = arc_ = firstStep_ * rate.norm();
        direction_ = rate;
    }
    const double time = std::copysign(arc_ / rate.norm(), direction_.dot(rate));
    return {start.displacement + time * rate, start.time + time};
}

bool ArcLength::isInRange(const Iterate& iterate) const {
    const double distance = (iterate.displacement - state_.displacement).norm();
    return distance <= farAway * arc_ && std::abs(iterate.time) <= farInTime * farthestTime_;
}

bool ArcLength::goesOn(const Iterate& iterate, const Iterate& predicted) const {
    const VectorXd chord = iterate.displacement - state_.displacement;
    const VectorXd tangent = predicted.displacement - state_.displacement;
    return chord.dot(tangent) >= leastCosine * chord.norm() * tangent.norm();
}

// Newton's method, on an arc of a length or, without one, at the iterate's time.
bool ArcLength::converge(Iterate& iterate, std::optional<double> arc) {
    iterate.displacement = asSupported(model_, iterate.displacement, iterate.time);
    VectorXd linearisedAt = state_.displacement;
    for (nIterations_ = 0;; ++nIterations_) {
        if (!isInRange(iterate)) {
            failure_ =
                fmt::format("an iterate left the range of the loads, at t = {:.3g}", iterate.time);
            return false;
        }
        const VectorXd external = force(iterate);
        const StructuralModel::Internal internal = internalForce(iterate);
        VectorXd residual = external - internal.force;
        setFixedToZero(model_.fixed(), residual);
        residual_ = residual.norm() / std::max(external.norm(), internal.force.norm());
        const VectorXd step = iterate.displacement - state_.displacement;
        const double excess = arc ? step.squaredNorm() - *arc * *arc : 0;
        const bool isBalanced =
            residual_ <= newton_.tolerance || residual.norm() <= rounding_.at(iterate.displacement);
        if (isBalanced && std::abs(excess) <= arcTolerance * arc_ * arc_) {
            failure_ = "the body is turned inside out";
            return internal.smallestVolumeRatio > 0;
        }
        if (nIterations_ == newton_.maxIterations || !std::isfinite(residual_)) {
            failure_ = fmt::format("relative residual {:.2e}, tolerance {:g}, after {} iterations",
                                   residual_, newton_.tolerance, nIterations_);
            return false;
        }
        factorise(iterate, &linearisedAt);
        linearisedAt = iterate.displacement;
        VectorXd move = solver_->solve(residual);
        if (arc) {
            const VectorXd rate = this->rate(iterate);
            const double time = -(0.5 * excess + step.dot(move)) / step.dot(rate);
            move += time * rate;
            iterate.time += time;
        }
        iterate.displacement = asSupported(model_, iterate.displacement + move, iterate.time);
    }
}

bool ArcLength::passesEnd(const Iterate& iterate) const {
    return state_.time < end_ && iterate.time > end_;
}

// Whatever an iterate breaks, a singular tangent or a formula outside its range, is the
// failure of the step.
template <class Attempt>
std::optional<ArcLength::Iterate> ArcLength::guarded(const Attempt& attempt) {
    try {
        return attempt();
    } catch (const SolverError& error) {
        failure_ = error.what();
    } catch (const InputError& error) {
        failure_ = error.what();
    }
    return std::nullopt;
}

// A step of the arc, or what is left to the end; none if it fails.
std::optional<ArcLength::Iterate> ArcLength::attempt() {
    const Iterate predicted = predict();
    if (passesEnd(predicted)) {
        if (auto end = guarded([&] { return attemptEnd(predicted); })) {
            return end;
        }
    }
    return guarded([&] { return attemptArc(predicted); });
}

std::optional<ArcLength::Iterate> ArcLength::attemptArc(const Iterate& predicted) {
    Iterate iterate = predicted;
    if (!converge(iterate, arc_)) {
        return std::nullopt;
    }
    if (!goesOn(iterate, predicted)) {
        failure_ = "the path turns by more than 60 degrees in a step";
        return std::nullopt;
    }
    return passesEnd(iterate) ? attemptEnd(iterate) : iterate;
}

// The path meets the end before a point beyond it, so within the arc.
std::optional<ArcLength::Iterate> ArcLength::attemptEnd(const Iterate& beyond) {
    const double part = (end_ - state_.time) / (beyond.time - state_.time);
    Iterate iterate{state_.displacement + part * (beyond.displacement - state_.displacement), end_};
    if (!converge(iterate, std::nullopt)) {
        return std::nullopt;
    }
    const double distance = (iterate.displacement - state_.displacement).norm();
    if (distance > arc_ || !goesOn(iterate, beyond)) {
        failure_ = "the equilibrium at the end does not lie on the path";
        return std::nullopt;
    }
    return iterate;
}

void ArcLength::accept(const Iterate& iterate) {
    direction_ = iterate.displacement - state_.displacement;
    lastArc_ = direction_.norm();
    const VectorXd force = forceAndReaction(iterate);
    const VectorXd middle = 0.5 * (iterate.displacement + state_.displacement);
    externalWork_ += model_.supportShift(iterate.time).energyAt(middle) -
                     model_.supportShift(state_.time).energyAt(middle);
    externalWork_ += 0.5 * direction_.dot(force + totalForce_);
    totalForce_ = force;
    state_.displacement = iterate.displacement;
    state_.time = iterate.time;
    state_.force = model_.externalForce(iterate.time);
    farthestTime_ = std::max(farthestTime_, std::abs(iterate.time));
}

StepEffort ArcLength::advance() {
    nSolutions_ = 0;
    while (true) {
        if (const std::optional<Iterate> end = attempt()) {
            accept(*end);
            const double growth = std::sqrt(wantedIterations / std::max(nIterations_, 1));
            arc_ = std::min(arc_ * std::clamp(growth, 0.5, 2.0), path_.maxGrowth * firstArc_);
            return {nSolutions_, residual_,
                    fmt::format("arcLength, arc {:.3g} of the first", lastArc_ / firstArc_)};
        }
        arc_ *= 0.5;
        if (arc_ < shortest * firstArc_) {
            throwLost();
        }
    }
}

void ArcLength::throwLost() const {
    throw SolverError(fmt::format(
        "time {:.6g} s: the equilibrium path cannot be followed, even by a step of {:g} of the "
        "first one ({}); use a smaller time.step, or check loads and material",
        state_.time, shortest, failure_));
}

} // namespace tokay::structure
