// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/CoupledStructure.hpp"

#include "coupling/StateReader.hpp"
#include "coupling/StateWriter.hpp"
#include "igaStructure/coupledRun/interfaceBalance.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

Eigen::VectorXd initialDisplacement(const std::optional<StartState>& start,
                                    const StructuralModel& model) {
    return start ? start->saved.motion.displacement
                 : Eigen::VectorXd(Eigen::VectorXd::Zero(model.nUnknowns()));
}

} // namespace

CoupledStructure::CoupledStructure(const Case& structureCase, Body& body,
                                   const WetBoundary& boundary, const channel::Interface& fluid,
                                   PhaseTimer& timer, const Report& report)
    : case_(structureCase), boundary_(boundary), timer_(timer),
      integrator_(body.model(), structureCase.timeScheme, structureCase.newton, fluid.startTime,
                  structureCase.coupling->substeps),
      start_(findStartState(structureCase, body.model().nUnknowns(), boundary, fluid)),
      structure_(body.model(), integrator_, boundary, timer),
      scheme_(makeCouplingScheme(structureCase.coupling->options, fluid.tolerance, structure_,
                                 initialDisplacement(start_, body.model()), timer)),
      output_(structureCase, body, begin(start_, report), fluid.endTime, report),
      audits_(fluid.audit) {
    if (start_) {
        output_.continueEarlier();
        start_.reset();
    }
}

// State at the start, which integrator and scheme have then.
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
        restoreScheme(state, report);
    }
    return integrator_.state();
}

void CoupledStructure::restoreScheme(coupling::StateReader& state, const Report& report) {
    if (state.text() == scheme_->name()) {
        scheme_->restore(state);
    } else {
        report("note: the acceleration is another one than then: predictor and acceleration begin "
               "anew\n");
    }
}

// A run that goes on from there has no tangent either.
void CoupledStructure::save() {
    SavedState state{case_.digest,       integrator_.state(), integrator_.energies(),
                     boundary_.points(), scheme_->x(),        {}};
    coupling::StateWriter write(state.coupling);
    write.text(scheme_->name());
    scheme_->save(write);
    stateFolder(case_).add(state);
    integrator_.dropTangent();
}

Eigen::VectorXd CoupledStructure::beginTimeStep(int step, double time, double deltaT) {
    report_ = {};
    report_.step = step;
    deltaT_ = deltaT;
    structure_.beginTimeStep(time, deltaT);
    return timer_.time(Phase::acceleration, [&] { return scheme_->beginTimeStep(deltaT); });
}

Answer CoupledStructure::iterate(const std::vector<double>& forces, double fluidResidual) {
    ++report_.nExchanges;
    const coupling::Iteration iteration = scheme_->iterate(forces, fluidResidual);
    return {iteration.x, iteration.residual, iteration.converged};
}

Answer CoupledStructure::acceptTimeStep(const std::vector<double>& forces, bool writeResults) {
    const Eigen::VectorXd before = integrator_.state().displacement;
    ++report_.nExchanges;
    const Eigen::VectorXd xTilde = scheme_->finalAnswer(forces);
    timer_.time(Phase::solving, [&] { integrator_.acceptTimeStep(); });
    report_.lastResidual =
        timer_.time(Phase::acceleration, [&] { return scheme_->acceptTimeStep(xTilde); });
    report_.firstResidual = scheme_->statistics().firstResidual;
    report_.nColumns = scheme_->statistics().nColumns;
    report_.nIterations = structure_.nIterations();
    if (writeResults) {
        timer_.time(Phase::output, [&] { save(); });
    }
    output_.finishStep(report_, integrator_.state(), integrator_.energies(), timer_, writeResults);
    Answer answer{xTilde, report_.lastResidual, true};
    if (audits_) {
        answer.balance = interfaceBalance(boundary_, {forces, before, structure_.mappedAt(),
                                                      integrator_.state().displacement, deltaT_});
    }
    return answer;
}

void CoupledStructure::rejectTimeStep() {
    integrator_.rejectTimeStep();
    scheme_->rejectTimeStep();
}

} // namespace tokay::structure
