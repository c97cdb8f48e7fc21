// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/ArcLength.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

// Iterations below which a step counts as easy, and the next one grows.
constexpr int easyIterations = 4;
constexpr double shortest = 1.0 / 1024;

} // namespace

ArcLength::ArcLength(StructuralModel& model, const NewtonOptions& newton, double firstStep)
    : model_(model), newton_(newton), firstStep_(firstStep) {
    state_.displacement = VectorXd::Zero(model.nUnknowns());
    state_.velocity = state_.acceleration = state_.displacement;
    state_.force = model.externalForce(0);
    totalForce_ = force({state_.displacement, 0});
    SparseMatrix atRest;
    model_.internalForce(state_.displacement, atRest);
    solver_ = makeLinearSolver(atRest, model.fixed(), MatrixKind::general);
}

VectorXd ArcLength::force(const Iterate& at) const {
    VectorXd force = model_.externalForce(at.time);
    model_.addFollowerForce(at.displacement, at.time, force);
    return force;
}

VectorXd ArcLength::loadRate(const Iterate& at) const {
    // Formulas are smooth in time, most of them linear: then this is exact.
    const double h = 1e-4 * firstStep_;
    return (force({at.displacement, at.time + h}) - force({at.displacement, at.time - h})) /
           (2 * h);
}

void ArcLength::factorise(const Iterate& at) {
    SparseMatrix tangent;
    model_.internalForce(at.displacement, tangent);
    model_.subtractFollowerDerivative(at.displacement, at.time, tangent);
    solver_->factorise(tangent);
}

ArcLength::Iterate ArcLength::predict() {
    const Iterate start{state_.displacement, state_.time};
    factorise(start);
    const VectorXd rate = solver_->solve(loadRate(start));
    if (!(rate.norm() > 0)) {
        throw SolverError("the loads do not change with time, so there is no path to follow; give "
                          "them a factor t");
    }
    if (firstLength_ == 0) {
        firstLength_ = length_ = firstStep_ * rate.norm();
        direction_ = rate;
    }
    const double time = std::copysign(length_ / rate.norm(), direction_.dot(rate));
    return {start.displacement + time * rate, start.time + time};
}

bool ArcLength::correct(Iterate& iterate) {
    for (nIterations_ = 0; nIterations_ < newton_.maxIterations; ++nIterations_) {
        const VectorXd external = force(iterate);
        const VectorXd internal = model_.internalForce(iterate.displacement).force;
        VectorXd residual = external - internal;
        setFixedToZero(model_.fixed(), residual);
        residual_ = residual.norm() / std::max(external.norm(), internal.norm());
        if (!std::isfinite(residual_)) {
            return false;
        }
        const VectorXd step = iterate.displacement - state_.displacement;
        const double excess = step.squaredNorm() - length_ * length_;
        if (residual_ <= newton_.tolerance && std::abs(excess) <= 1e-6 * length_ * length_) {
            return true;
        }
        factorise(iterate);
        const VectorXd move = solver_->solve(residual);
        const VectorXd rate = solver_->solve(loadRate(iterate));
        const double time = -(0.5 * excess + step.dot(move)) / step.dot(rate);
        iterate.displacement += move + time * rate;
        iterate.time += time;
    }
    return false;
}

void ArcLength::accept(const Iterate& iterate) {
    direction_ = iterate.displacement - state_.displacement;
    const VectorXd force = this->force(iterate);
    externalWork_ += 0.5 * direction_.dot(force + totalForce_);
    totalForce_ = force;
    state_.displacement = iterate.displacement;
    state_.time = iterate.time;
    state_.force = model_.externalForce(iterate.time);
}

void ArcLength::advance() {
    while (true) {
        Iterate iterate = predict();
        if (correct(iterate)) {
            accept(iterate);
            if (nIterations_ <= easyIterations) {
                length_ = std::min(2 * length_, firstLength_);
            }
            return;
        }
        length_ *= 0.5;
        if (length_ < shortest * firstLength_) {
            throw SolverError(fmt::format(
                "time {:.6g} s: the equilibrium path cannot be followed, even by a step of 1/1024 "
                "of the first one (relative residual {:.2e}, tolerance {:g}); use a smaller "
                "time.step, or check loads and material",
                state_.time, residual_, newton_.tolerance));
        }
    }
}

} // namespace tokay::structure
