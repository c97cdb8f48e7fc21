// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/step/ConvergenceCriteria.hpp"

#include "common/errors.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace tokay::coupling {

using Eigen::VectorXd;

namespace {

/// Relative change of force that the automatic criterion allows, but no less than the tolerance
/// and no more than ten.
constexpr double usualForceLimit = 1e-3;

/// Momentum residual of a flow that has converged, if the coupling's tolerance is looser: at
/// 5e-3 the motion of a heavy flap is still wrong by more than a percent.
constexpr double convergedMomentum = 1e-4;

/// Of a force that there is nothing to compare with: not met, and no more than that, so that
/// the residual shows the displacement's.
constexpr double unknownRatio = 2;

double rootMeanSquare(const VectorXd& values) {
    return values.size() == 0 ? 0 : values.norm() / std::sqrt(double(values.size()));
}

double ratio(double norm, double allowed) {
    return norm == 0 ? 0 : norm / allowed;
}

} // namespace

const SchemaOf<ConvergenceOptions>& ConvergenceOptions::schema() {
    static const Choices<ForceCriterion> criteria = {
        {"automatic", ForceCriterion::automatic,
         "the force changes by less than 1e-3 (at least one tolerance, at most ten), relative to "
         "the force or its mean over the run; or the momentum residual is below the tolerance "
         "and below 1e-4."},
        {"none", ForceCriterion::none, "the force is not checked."}};
    static const SchemaOf<ConvergenceOptions> schema = {
        {"absoluteDisplacement", &ConvergenceOptions::absoluteDisplacement, "[0, inf)", "m",
         "A root-mean-square displacement residual below this is converged in any case."},
        {"force", &ConvergenceOptions::force, criteria,
         "Criterion on the force if neither relativeForce nor absoluteForce is given."},
        {"relativeForce", &ConvergenceOptions::relativeForce, "[0, 1)", "",
         "Limit of the change of force between coupling iterations, relative to the force or its "
         "mean over the run; 0: none."},
        {"absoluteForce", &ConvergenceOptions::absoluteForce, "[0, inf)", "N (2D: N/m)",
         "A root-mean-square change of force below this is converged in any case; 0: none."}};
    return schema;
}

ConvergenceCriteria::ConvergenceCriteria(const ConvergenceOptions& options, double tolerance)
    : tolerance_(tolerance), options_(options) {
    if (!(tolerance > 0 && tolerance <= 1)) {
        throw InputError("the coupling tolerance is " + std::to_string(tolerance) +
                         ": it must be above 0, and below 1 unless the coupling is "
                         "explicit; it is the fluid's residualControl for the "
                         "structure");
    }
}

double ConvergenceCriteria::residual(const VectorXd& x, const VectorXd& xTilde,
                                     const VectorXd& forces, std::optional<double> fluidResidual) {
    flowHasConverged_ = fluidResidual && *fluidResidual < std::min(tolerance_, convergedMomentum);
    const double result = finalResidual(x, xTilde, forces);
    previousForces_ = forces;
    return result;
}

double ConvergenceCriteria::finalResidual(const VectorXd& x, const VectorXd& xTilde,
                                          const VectorXd& forces) const {
    const double ofDisplacement = displacementResidual(x, xTilde);
    if (flowHasConverged_ && !options_.hasForceLimits()) {
        return ofDisplacement;
    }
    return std::max(ofDisplacement, tolerance_ * forceRatio(forces));
}

double ConvergenceCriteria::displacementResidual(const VectorXd& x, const VectorXd& xTilde) const {
    assert(xTilde.size() == x.size());
    if (!xTilde.allFinite()) {
        throw SolverError("the structure's displacement is not finite");
    }
    const double scale = std::max(rootMeanSquare(x), rootMeanSquare(xTilde));
    return tolerance_ * ratio(rootMeanSquare(xTilde - x),
                              std::max(tolerance_ * scale, options_.absoluteDisplacement));
}

double ConvergenceCriteria::forceRatio(const VectorXd& forces) const {
    if (!options_.limitsForce()) {
        return 0;
    }
    return previousForces_.size() == forces.size()
               ? ratio(rootMeanSquare(forces - previousForces_), allowedForceChange(forces))
               : unknownRatio;
}

double ConvergenceCriteria::allowedForceChange(const VectorXd& forces) const {
    const double relative = options_.hasForceLimits()
                                ? options_.relativeForce
                                : std::clamp(usualForceLimit, tolerance_, 10 * tolerance_);
    return std::max(relative * std::max(rootMeanSquare(forces), meanForce_),
                    options_.absoluteForce);
}

void ConvergenceCriteria::acceptTimeStep(const VectorXd& forces) {
    ++nTimeSteps_;
    meanForce_ += (rootMeanSquare(forces) - meanForce_) / nTimeSteps_;
}

void ConvergenceCriteria::save(StateWriter& state) const {
    state.number(meanForce_);
    state.integer(nTimeSteps_);
}

void ConvergenceCriteria::restore(StateReader& state) {
    meanForce_ = state.number();
    nTimeSteps_ = state.integer();
}

} // namespace tokay::coupling
