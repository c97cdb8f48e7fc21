#include "igaStructure/run/CoupledStructure.hpp"

#include "coupling/StateReader.hpp"
#include "coupling/StateWriter.hpp"
#include "igaStructure/run/interfaceBalance.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

Eigen::VectorXd initialDisplacement(const std::optional<StartState>& start,
                                    const WetBoundary& boundary) {
    return start ? boundary.displacements(start->saved.motion.displacement)
                 : Eigen::VectorXd(Eigen::VectorXd::Zero(boundary.nComponents()));
}

} // namespace

CoupledStructure::CoupledStructure(const Case& structureCase, Body& body,
                                   const WetBoundary& boundary, const coupling::Interface& fluid,
                                   PhaseTimer& timer, const Report& report)
    : case_(structureCase), boundary_(boundary), timer_(timer),
      integrator_(body.model(), structureCase.timeScheme, structureCase.newton, fluid.startTime),
      start_(findStartState(structureCase, body.model().nUnknowns(), boundary, fluid)),
      driver_(structureCase.coupling->options, fluid.tolerance,
              initialDisplacement(start_, boundary)),
      output_(structureCase, body, begin(start_, report), fluid.endTime, report),
      audits_(fluid.audit) {
    if (start_) {
        output_.continueEarlier();
        start_.reset();
    }
}

// State at the start, which integrator and driver have then.
const MotionState& CoupledStructure::begin(const std::optional<StartState>& start,
                                           const Report& report) {
    if (start) {
        integrator_.restore(start->saved.motion, start->saved.energies);
        report(fmt::format("goes on from the saved state of {:.9g} s\n", start->saved.motion.time));
    }
    if (start && start->components.empty()) {
        report("note: the fluid's interface has another mesh than then: predictor and acceleration "
               "begin anew\n");
    } else if (start) {
        coupling::StateReader state(start->saved.coupling);
        state.renumberInterface(start->components);
        driver_.restore(state);
    }
    return integrator_.state();
}

void CoupledStructure::save() const {
    SavedState state{case_.digest,       integrator_.state(), integrator_.energies(),
                     boundary_.points(), driver_.x(),         {}};
    coupling::StateWriter write(state.coupling);
    driver_.save(write);
    stateFolder(case_).add(state);
}

Eigen::VectorXd CoupledStructure::beginTimeStep(int step, double time, double deltaT) {
    report_ = {};
    report_.step = step;
    deltaT_ = deltaT;
    integrator_.beginTimeStep(time, deltaT);
    return timer_.time(Phase::acceleration, [&] { return driver_.beginTimeStep(deltaT); });
}

Eigen::VectorXd CoupledStructure::solve(const std::vector<double>& forces) {
    const Eigen::VectorXd force = timer_.time(
        Phase::mapping, [&] { return boundary_.forces(forces, integrator_.displacement()); });
    timer_.time(Phase::solving, [&] { integrator_.solve(force); });
    ++report_.nExchanges;
    report_.nIterations += integrator_.nIterations();
    return timer_.time(Phase::mapping,
                       [&] { return boundary_.displacements(integrator_.displacement()); });
}

Answer CoupledStructure::iterate(const std::vector<double>& forces, double fluidResidual) {
    const Eigen::VectorXd xTilde = solve(forces);
    const coupling::Iteration iteration = timer_.time(Phase::acceleration, [&] {
        const Eigen::Map<const Eigen::VectorXd> faceForces(forces.data(), forces.size());
        return driver_.iterate(xTilde, fluidResidual, faceForces);
    });
    return {iteration.x, iteration.residual, iteration.converged};
}

Answer CoupledStructure::acceptTimeStep(const std::vector<double>& forces, bool writeResults) {
    AuditedStep audited{
        forces, integrator_.state().displacement, integrator_.displacement(), {}, deltaT_};
    const Eigen::VectorXd xTilde = solve(forces);
    timer_.time(Phase::solving, [&] { integrator_.acceptTimeStep(); });
    audited.after = integrator_.displacement();
    report_.lastResidual =
        timer_.time(Phase::acceleration, [&] { return driver_.acceptTimeStep(xTilde); });
    report_.firstResidual = driver_.statistics().firstResidual;
    report_.nColumns = driver_.statistics().nColumns;
    if (writeResults) {
        timer_.time(Phase::output, [&] { save(); });
    }
    output_.finishStep(report_, integrator_.state(), integrator_.energies(), timer_, writeResults);
    Answer answer{xTilde, report_.lastResidual, true};
    if (audits_) {
        answer.balance = interfaceBalance(boundary_, audited);
    }
    return answer;
}

void CoupledStructure::rejectTimeStep() {
    integrator_.rejectTimeStep();
    driver_.rejectTimeStep();
}

} // namespace tokay::structure
