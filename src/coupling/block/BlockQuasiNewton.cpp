// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/BlockQuasiNewton.hpp"

#include "common/errors.hpp"
#include "coupling/block/BlockSystem.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <cassert>
#include <cmath>

namespace tokay::coupling {

using Eigen::VectorXd;

namespace {

/// Fraction of the coupling's tolerance that Newton's method may leave, in a coupling iteration
/// and of the accepted solution, whose error over the time step squared is an acceleration.
constexpr double newtonFraction = 0.1;
constexpr double acceptedFraction = 0.01;

} // namespace

const SchemaOf<BlockQuasiNewton::Options>& BlockQuasiNewton::Options::schema() {
    static const SchemaOf<Options> schema =
        SchemaOf<Options>()
            .with(InitialRelaxation::schema())
            .with(ResponseOptions::schema())
            .with(SchemaOf<Options>{
                {"signalToNoise", &Options::signalToNoise, "[0, inf)", "",
                 "Noise by which differences are weighted, in units of the fluid's residual; 0: "
                 "none."}})
            .with(FluidLag::Options::schema());
    return schema;
}

BlockQuasiNewton::BlockQuasiNewton(const CouplingOptions& options, double tolerance,
                                   LinearisedStructure& structure)
    : options_(options.acceleration.of<Options>()), criteria_(options.convergence, tolerance),
      structure_(structure), steps_(structure),
      predictor_(options.predictor, structure.acceptedUnknowns()), model_(options_), lag_(options_),
      now_(at(structure.acceptedUnknowns())), next_(now_) {}

BlockQuasiNewton::InterfaceState BlockQuasiNewton::at(const VectorXd& d) const {
    return {d, structure_.displacements(d)};
}

const VectorXd& BlockQuasiNewton::predict(double deltaT) {
    assert(deltaT > 0);
    deltaT_ = deltaT;
    statistics_ = {};
    criteria_.beginTimeStep();
    lag_.beginTimeStep();
    previousX_.resize(0);
    if (deltaTOfModel_ > 0 && deltaTOfModel_ != deltaT) {
        model_.changeTimeStep(deltaTOfModel_ / deltaT);
    }
    deltaTOfModel_ = deltaT;
    model_.beginTimeStep();
    next_ = at(predictor_.predict(deltaT));
    now_ = next_;
    return next_.x;
}

CouplingIteration BlockQuasiNewton::iterate(const VectorXd& faceForces,
                                            std::optional<double> fluidResidual) {
    assert(deltaT_ > 0 && std::isfinite(fluidResidual.value_or(0)));
    now_ = next_;
    const VectorXd loads = lag_.corrected(structure_.loads(faceForces, now_.d));
    learn(loads, fluidResidual.value_or(0));
    const double residual =
        criteria_.residual(now_.x, newtonPrediction(loads), faceForces, fluidResidual);
    next_ = nextState(loads, newtonFraction * criteria_.tolerance());
    statistics_.add(residual, criteria_.tolerance(), model_.matrix().rank());
    return {next_.x, residual, statistics_.converged};
}

void BlockQuasiNewton::learn(const VectorXd& loads, double fluidResidual) {
    const bool hasMoved = previousX_.size() != 0 && previousX_ != now_.x;
    if (hasMoved && lag_.isInformative()) {
        // A move within the fluid's own error teaches little but its drift.
        const double noise = options_.signalToNoise * fluidResidual * now_.x.norm();
        model_.learn(now_.x - previousX_, loads - previousLoads_, noise);
    }
    previousX_ = now_.x;
    previousLoads_ = loads;
}

/// Displacement under these loads by one step of Newton's method, which is
/// enough to tell how far the present one is from it.
VectorXd BlockQuasiNewton::newtonPrediction(const VectorXd& loads) const {
    if (structure_.reuseContraction() == 0) {
        structure_.linearise(now_.d);
    }
    const VectorXd imbalance = loads - structure_.residual(now_.d);
    return now_.x + structure_.variations(structure_.responses(imbalance));
}

/// Where the structure is in balance with a fluid that responds to it by J.
BlockQuasiNewton::InterfaceState BlockQuasiNewton::nextState(const VectorXd& loads,
                                                             double tolerance) {
    const auto solve = [&] {
        const BlockSystem system(structure_, steps_, loads, now_.x, model_.matrix());
        return system.solve(now_.d, tolerance);
    };
    if (!model_.isEmpty()) {
        try {
            return at(solve());
        } catch (const SolverError&) {
            // In such a fluid there is no solution, so it has been learned wrongly.
            model_.reset();
        }
    }
    return at(now_.d + options_.initialRelaxation * (solve() - now_.d));
}

CouplingIteration BlockQuasiNewton::accept(const VectorXd& finalForces, double limit) {
    assert(deltaT_ > 0);
    // Loads as they are: the final corrector has had the displacement of the one before.
    const VectorXd loads = structure_.loads(finalForces, now_.d);
    const InterfaceState next = nextState(loads, acceptedFraction * criteria_.tolerance());
    const VectorXd d =
        structure_.solveFor(loads + model_.matrix().apply(next.x - now_.x, loads.size()), next.d);
    const VectorXd xTilde = structure_.displacements(d);
    const double residual = criteria_.finalResidual(now_.x, xTilde, finalForces);
    if (!(residual < limit)) {
        next_ = now_; // where the fluid has stayed
        return {now_.x, residual, false};
    }
    model_.acceptTimeStep();
    predictor_.accept(d, deltaT_);
    criteria_.acceptTimeStep(finalForces);
    deltaT_ = 0;
    return {xTilde, residual, true};
}

void BlockQuasiNewton::reject() {
    model_.rejectTimeStep();
    lag_.rejectTimeStep();
    deltaT_ = 0;
}

void BlockQuasiNewton::save(StateWriter& state) const {
    predictor_.save(state);
    state.number(deltaTOfModel_);
    model_.save(state);
    lag_.save(state);
    criteria_.save(state);
}

void BlockQuasiNewton::restore(StateReader& state) {
    predictor_.restore(state, Predictor::Values::ofStructure);
    deltaTOfModel_ = state.number();
    model_.restore(state);
    lag_.restore(state);
    criteria_.restore(state);
}

} // namespace tokay::coupling
