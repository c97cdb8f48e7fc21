// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/BlockQuasiNewton.hpp"

#include "common/errors.hpp"
#include "coupling/BlockSystem.hpp"
#include "coupling/StateReader.hpp"
#include "coupling/StateWriter.hpp"

#include <cassert>
#include <cmath>

namespace tokay::coupling {
namespace {

const CouplingOptions& valid(const CouplingOptions& options) {
    requireValid(options);
    return options;
}

/// Of the coupling's tolerance, what Newton's method may leave.
constexpr double shareOfTolerance = 0.1;

} // namespace

BlockQuasiNewton::BlockQuasiNewton(const CouplingOptions& options, double tolerance,
                                   TangentStructure& structure, const Eigen::VectorXd& initial)
    : options_(valid(options)), criteria_(options, tolerance), structure_(structure),
      predictor_(options.extrapolation, initial), model_(options_),
      memory_(options.fluidMemory, options.memoryContrast), now_(at(initial)), next_(now_) {}

BlockQuasiNewton::Position BlockQuasiNewton::at(const Eigen::VectorXd& d) const {
    return {d, structure_.displacements(d)};
}

const Eigen::VectorXd& BlockQuasiNewton::beginTimeStep(double deltaT) {
    assert(deltaT > 0);
    deltaT_ = deltaT;
    statistics_ = {};
    criteria_.beginTimeStep();
    memory_.beginTimeStep();
    previousX_.resize(0);
    if (deltaTOfModel_ > 0 && deltaTOfModel_ != deltaT) {
        // The fluid's inertia answers accelerations: forces go as x / Δt².
        model_.scale(std::pow(deltaTOfModel_ / deltaT, 2));
    }
    deltaTOfModel_ = deltaT;
    model_.beginTimeStep();
    next_ = at(predictor_.predict(deltaT));
    now_ = next_;
    return next_.x;
}

Iteration BlockQuasiNewton::iterate(const Eigen::VectorXd& forces, double fluidResidual) {
    assert(deltaT_ > 0);
    now_ = next_;
    const Eigen::VectorXd loads = memory_.corrected(structure_.loads(forces, now_.d));
    if (!loads.allFinite() || !std::isfinite(fluidResidual)) {
        throw SolverError("the fluid's forces or their residual are not finite");
    }
    learn(loads, fluidResidual);
    const double residual = criteria_.residual(now_.x, structuresAnswer(loads), forces);
    next_ = nextPosition(loads);

    if (statistics_.nExchanges == 0) {
        statistics_.firstResidual = residual;
    }
    ++statistics_.nExchanges;
    statistics_.lastResidual = residual;
    statistics_.converged = residual < criteria_.tolerance();
    statistics_.nColumns = model_.matrix().rank();
    return {next_.x, residual, statistics_.converged};
}

void BlockQuasiNewton::learn(const Eigen::VectorXd& loads, double fluidResidual) {
    if (previousX_.size() != 0) {
        const Eigen::VectorXd v = now_.x - previousX_;
        const Eigen::VectorXd w = loads - previousLoads_;
        if (memory_.teaches()) {
            // A move within the fluid's own error teaches little but its drift.
            model_.learn(v, w, options_.signalToNoise * fluidResidual * now_.x.norm());
        }
    }
    previousX_ = now_.x;
    previousLoads_ = loads;
}

/// Displacement under these loads by one step of Newton's method, which is
/// enough to tell how far the present one is from it.
Eigen::VectorXd BlockQuasiNewton::structuresAnswer(const Eigen::VectorXd& loads) const {
    structure_.factor(now_.d);
    const Eigen::VectorXd imbalance = loads - structure_.residual(now_.d);
    return now_.x + structure_.variations(structure_.solve(imbalance));
}

BlockQuasiNewton::Position BlockQuasiNewton::nextPosition(const Eigen::VectorXd& loads) {
    const auto answer = [&] {
        const BlockSystem system(structure_, loads, now_.x, model_.matrix());
        return system.solve(now_.d, shareOfTolerance * criteria_.tolerance());
    };
    if (!model_.isIgnorant()) {
        try {
            return at(answer());
        } catch (const SolverError&) {
            // In such a fluid there is no answer, so it has been learned wrongly.
            model_.forget();
        }
    }
    return at(now_.d + options_.initialRelaxation * (answer() - now_.d));
}

Eigen::VectorXd BlockQuasiNewton::finalLoads(const Eigen::VectorXd& forces) {
    // As they are: the final corrector has had the displacement of the one before.
    const Eigen::VectorXd loads = structure_.loads(forces, now_.d);
    const Position end = nextPosition(loads);
    return loads + model_.matrix().apply(end.x - now_.x, loads.size());
}

double BlockQuasiNewton::acceptTimeStep(const Eigen::VectorXd& d) {
    assert(deltaT_ > 0);
    const double residual = criteria_.displacementResidual(now_.x, structure_.displacements(d));
    model_.acceptTimeStep();
    predictor_.accept(d, deltaT_);
    deltaT_ = 0;
    return residual;
}

void BlockQuasiNewton::rejectTimeStep() {
    model_.rejectTimeStep();
    memory_.rejectTimeStep();
    deltaT_ = 0;
}

void BlockQuasiNewton::save(StateWriter& state) const {
    predictor_.save(state);
    state.number(deltaTOfModel_);
    model_.save(state);
    memory_.save(state);
}

void BlockQuasiNewton::restore(StateReader& state) {
    predictor_.restore(state, Predictor::Values::ofStructure);
    deltaTOfModel_ = state.number();
    model_.restore(state);
    memory_.restore(state);
}

} // namespace tokay::coupling
