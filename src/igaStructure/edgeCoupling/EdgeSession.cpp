// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/edgeCoupling/EdgeSession.hpp"

#include "common/errors.hpp"
#include "igaStructure/coupledRun/restart/StartState.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tokay::structure {

using channel::Displacements;
using channel::State;
using Eigen::VectorXd;

EdgeSession::EdgeSession(const Case& structureCase, const Body& body, MovedStructure& moved,
                         const std::optional<SavedState>& start, const mapper::EdgeQuadrature& edge,
                         FluidLink& link, Report report)
    : case_(structureCase), moved_(moved), edge_(edge), states_(stateFolder(structureCase)),
      startTime_(moved.state().time),
      startDisplacements_(static_cast<std::size_t>(moved.dimension() * edge.nPoints()), 0),
      link_(link), report_(report),
      output_(structureCase, body, moved.state(), structureCase.timeSteps->end, std::move(report)) {
    if (start) {
        startDisplacements_.assign(start->interfaceDisplacement.begin(),
                                   start->interfaceDisplacement.end());
        output_.continueEarlier();
    }
}

channel::Interface EdgeSession::interface() const {
    const int dimension = moved_.dimension();
    channel::Interface interface;
    interface.dimension = static_cast<std::uint32_t>(dimension);
    interface.name = case_.name;
    interface.faceOffsets = {0};
    for (int k = 0; k < edge_.nPoints(); ++k) {
        for (int c = 0; c < dimension; ++c) {
            interface.points.push_back(edge_.points()(k, c));
        }
        interface.facePoints.push_back(static_cast<std::uint32_t>(k));
        interface.faceOffsets.push_back(static_cast<std::uint32_t>(k + 1));
    }
    interface.displacements = startDisplacements_;
    interface.tolerance = case_.coupling->tolerance.value_or(Coupling::defaultTolerance);
    interface.startTime = startTime_;
    interface.endTime = case_.timeSteps->end;
    interface.deltaT = case_.timeSteps->step;
    return interface;
}

void EdgeSession::run() {
    link_.send(interface());
    link_.receive<channel::Accepted>("the loaded structure to start");
    const TimeSteps& steps = *case_.timeSteps;
    for (int step = nStepsBefore() + 1; step <= steps.count(); ++step) {
        const bool isLast = step == steps.count();
        const double time = isLast ? steps.end : step * steps.step;
        advance(step, time, isLast ? time - (step - 1) * steps.step : steps.step,
                case_.output.writesAt(step, isLast));
    }
    link_.send(channel::Goodbye{"the last time step has been taken"});
    link_.receive<channel::Goodbye>("the loaded structure to end");
    reportIterations();
}

// Time steps of the case until the start.
int EdgeSession::nStepsBefore() const {
    return static_cast<int>(std::lround(startTime_ / case_.timeSteps->step));
}

void EdgeSession::save(const std::vector<double>& displacements, double deltaT) {
    const auto timed = timer_.enter(Phase::output);
    const VectorXd ofEdge = Eigen::Map<const VectorXd>(
        displacements.data(), static_cast<Eigen::Index>(displacements.size()));
    const MotionState state = moved_.state();
    const Energies energies = moved_.energies();
    states_.add(
        {case_.digest, state, energies, edge_.points(), ofEdge, VectorXd::Zero(ofEdge.size()), {}},
        deltaT);
    // The body's own unknowns have been rounded: what follows depends on what is saved alone.
    moved_.restore(state, energies);
}

Displacements EdgeSession::exchange(const channel::Message& message) {
    const auto timed = timer_.enter(Phase::waiting);
    link_.send(message);
    return link_.receive<Displacements>("the loaded structure's displacements");
}

void EdgeSession::advance(int step, double time, double deltaT, bool writes) {
    const int maxIterations =
        case_.coupling->maxIterations.value_or(Coupling::defaultMaxIterations);
    residuals_.clear();
    moved_.beginTimeStep(time, deltaT);
    Displacements answer =
        exchange(channel::BeginStep{static_cast<std::uint32_t>(step), time, deltaT});
    channel::Forces forces;
    forces.fluidResidual = 0;
    while (answer.state == State::iterate) {
        if (static_cast<int>(residuals_.size()) == maxIterations) {
            throwNotConverged(time);
        }
        const VectorXd displacements = Eigen::Map<const VectorXd>(
            answer.values.data(), static_cast<Eigen::Index>(answer.values.size()));
        const VectorXd reaction =
            timer_.time(Phase::solving, [&] { return moved_.forces(displacements); });
        forces.values.assign(reaction.begin(), reaction.end());
        answer = exchange(forces);
        residuals_.push_back(answer.residual);
    }
    forces.final = true;
    forces.write = writes;
    const Displacements accepted = exchange(forces);
    moved_.acceptTimeStep();
    if (writes) {
        save(accepted.values, deltaT);
    }

    StepReport report;
    report.step = step;
    report.nExchanges = static_cast<int>(residuals_.size());
    report.nIterations = moved_.nIterations();
    report.firstResidual = residuals_.front();
    report.lastResidual = residuals_.back();
    iterations_.push_back(report.nExchanges);
    output_.finishStep(report, moved_.state(), moved_.energies(), timer_, writes);
}

void EdgeSession::throwNotConverged(double time) const {
    throw SolverError(fmt::format(
        "time {:.6g} s: the two structures do not agree after {} coupling iterations "
        "(coupling.maxIterations); residuals {:.2e}, tolerance {:g}. Let the more flexible one, "
        "or the lighter one, be the moved one (coupling.side: dirichlet), choose another "
        "coupling.acceleration, or allow more iterations",
        time, residuals_.size(), fmt::join(residuals_, " "),
        case_.coupling->tolerance.value_or(Coupling::defaultTolerance)));
}

void EdgeSession::reportIterations() const {
    const double mean = std::accumulate(iterations_.begin(), iterations_.end(), 0.0) /
                        static_cast<double>(iterations_.size());
    report_(fmt::format("coupling iterations per time step: mean {:.2f}, at most {}", mean,
                        *std::max_element(iterations_.begin(), iterations_.end())));
}

} // namespace tokay::structure
