#include "coupling/BlockQuasiNewton.hpp"

#include "common/errors.hpp"
#include "coupling/BlockSystem.hpp"

#include <cassert>
#include <cmath>

namespace tokay::coupling {
namespace {

/// The guards of this method are its own: small columns are as good as others
/// once they have passed the tests on noise and memory.
CouplingOptions withoutKeepFraction(CouplingOptions options) {
    requireValid(options);
    options.keepFraction = 0;
    return options;
}

/// Of the coupling's tolerance, what Newton's method may leave.
constexpr double shareOfTolerance = 0.1;

} // namespace

BlockQuasiNewton::BlockQuasiNewton(const CouplingOptions& options, double tolerance,
                                   TangentStructure& structure, const Eigen::VectorXd& initial)
    : options_(withoutKeepFraction(options)), criteria_(options, tolerance), structure_(structure),
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
    next_ = at(predictor_.predict(deltaT));
    now_ = next_;
    return next_.x;
}

Iteration BlockQuasiNewton::iterate(const Eigen::VectorXd& forces, double fluidResidual) {
    assert(deltaT_ > 0);
    if (!forces.allFinite() || !std::isfinite(fluidResidual)) {
        throw SolverError("the fluid's forces or their residual are not finite");
    }
    now_ = next_;
    const Eigen::VectorXd corrected = memory_.corrected(forces);
    learn(corrected, fluidResidual);
    const double residual = criteria_.residual(now_.x, structuresAnswer(corrected), corrected);
    next_ = nextPosition(corrected);

    if (statistics_.nExchanges == 0) {
        statistics_.firstResidual = residual;
    }
    ++statistics_.nExchanges;
    statistics_.lastResidual = residual;
    statistics_.converged = residual < criteria_.tolerance();
    statistics_.nColumns = model_.rank();
    return {next_.x, residual, statistics_.converged};
}

void BlockQuasiNewton::learn(const Eigen::VectorXd& forces, double fluidResidual) {
    if (previousX_.size() != 0) {
        const Eigen::VectorXd v = now_.x - previousX_;
        const Eigen::VectorXd w = forces - previousForces_;
        const double noise = options_.signalToNoise * fluidResidual * forces.norm();
        if (v.norm() > 0 && w.norm() > noise && memory_.teaches()) {
            model_.learn(v, w);
        }
    }
    previousX_ = now_.x;
    previousForces_ = forces;
}

/// Displacement under these forces by one step of Newton's method, which is
/// enough to tell how far the present one is from it.
Eigen::VectorXd BlockQuasiNewton::structuresAnswer(const Eigen::VectorXd& forces) const {
    structure_.factor(now_.d);
    const Eigen::VectorXd imbalance = structure_.loads(forces) - structure_.residual(now_.d);
    return now_.x + structure_.displacements(structure_.solve(imbalance));
}

BlockQuasiNewton::Position BlockQuasiNewton::nextPosition(const Eigen::VectorXd& forces) const {
    const BlockSystem system(structure_, forces, now_.x, model_.matrix());
    const Eigen::VectorXd d = system.solve(now_.d, shareOfTolerance * criteria_.tolerance());
    if (model_.isIgnorant()) {
        return at(now_.d + options_.initialRelaxation * (d - now_.d));
    }
    return at(d);
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
    deltaT_ = 0;
}

} // namespace tokay::coupling
