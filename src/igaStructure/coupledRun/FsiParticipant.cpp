// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/FsiParticipant.hpp"

#include "channel/PeerError.hpp"
#include "coupling/couplingMethods.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"
#include "igaStructure/coupledRun/interfaceBalance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tokay::structure {

using Eigen::VectorXd;

FsiParticipant::FsiParticipant(const Case& structureCase, Body& body, const WetBoundary& boundary,
                               const channel::Interface& fluid, PhaseTimer& timer,
                               const Report& report)
    : case_(structureCase), boundary_(boundary), timer_(timer),
      integrator_(body.model(), *structureCase.implicitScheme(), structureCase.newton,
                  fluid.startTime, structureCase.coupling->substeps),
      structure_(body.model(), integrator_, boundary, timer), states_(stateFolder(structureCase)),
      tolerance_(fluid.tolerance), audits_(fluid.audit) {
    const std::optional<StartState> start =
        findStartState(structureCase, body.model().nUnknowns(), boundary.points(), fluid);
    if (start) {
        requireConsistent(*start, boundary.displacements(start->saved.motion.displacement));
        integrator_.restore(start->saved.motion, start->saved.energies);
    }
    method_ = makeCouplingMethod(structureCase.coupling->options, fluid.tolerance, structure_);
    if (start) {
        report(fmt::format("restarting from the saved state at t = {:.9g} s\n",
                           start->saved.motion.time));
        restoreMethod(*start, report);
    }
    output_ = std::make_unique<RunOutput>(structureCase, body, integrator_.state(), fluid.endTime,
                                          report);
    if (start) {
        output_->continueEarlier();
    }
}

void FsiParticipant::restoreMethod(const StartState& start, const Report& report) {
    if (start.components.empty()) {
        report("note: the fluid's interface has another mesh than the saved state's; predictor and "
               "acceleration history are reset\n");
        return;
    }
    coupling::StateReader state(start.saved.coupling);
    state.renumberInterface(start.components);
    try {
        if (state.text() == method_->name()) {
            method_->restore(state);
            return;
        }
    } catch (const channel::PeerError& error) {
        throwDamaged(start.saved.file, error.what());
    }
    report("note: the saved state used another acceleration; predictor and acceleration history "
           "are reset\n");
}

// A run that continues from there has no tangent either.
void FsiParticipant::save() {
    const auto timed = timer_.enter(Phase::output);
    const VectorXd ofStructure = boundary_.displacements(integrator_.state().displacement);
    const VectorXd residual = ofStructure - method_->x();
    SavedState state{case_.digest,
                     integrator_.state(),
                     integrator_.energies(),
                     boundary_.points(),
                     method_->x(),
                     residual,
                     {}};
    coupling::StateWriter write(state.coupling);
    write.text(method_->name());
    method_->save(write);
    states_.add(state, deltaT_);
    integrator_.dropTangent();
    method_->dropTangent();
}

VectorXd FsiParticipant::beginTimeStep(int step, double time, double deltaT) {
    const auto timed = timer_.enter(Phase::acceleration);
    report_ = {};
    report_.step = step;
    deltaT_ = deltaT;
    structure_.beginTimeStep(time, deltaT);
    return method_->predict(deltaT);
}

StructureResponse FsiParticipant::iterate(const VectorXd& faceForces,
                                          std::optional<double> fluidResidual) {
    const auto timed = timer_.enter(Phase::acceleration);
    ++report_.nExchanges;
    const coupling::CouplingIteration iteration = method_->iterate(faceForces, fluidResidual);
    return {iteration.x, iteration.residual, iteration.converged};
}

StructureResponse FsiParticipant::acceptTimeStep(const channel::Forces& final) {
    const VectorXd finalForces = Eigen::Map<const VectorXd>(
        final.values.data(), static_cast<Eigen::Index>(final.values.size()));
    const VectorXd before = integrator_.state().displacement;
    const coupling::CouplingIteration last = accept(
        finalForces, final.ifConverged ? tolerance_ : std::numeric_limits<double>::infinity());
    if (!last.converged) {
        StructureResponse response = iterate(finalForces, final.fluidResidual);
        response.residual = std::max(response.residual, last.residual);
        response.converged = false;
        return response;
    }
    if (final.write) {
        save();
    }
    writesResults_ = final.write;
    StructureResponse response{last.x, last.residual, true, true};
    if (audits_) {
        response.balance = interfaceBalance(boundary_, {finalForces, before, structure_.mappedAt(),
                                                        integrator_.state().displacement, deltaT_});
    }
    return response;
}

void FsiParticipant::finishTimeStep() {
    output_->finishStep(report_, integrator_.state(), integrator_.energies(), timer_,
                        writesResults_);
}

coupling::CouplingIteration FsiParticipant::accept(const VectorXd& finalForces, double limit) {
    const auto timed = timer_.enter(Phase::acceleration);
    const coupling::CouplingIteration last = method_->accept(finalForces, limit);
    if (!last.converged) {
        return last;
    }
    integrator_.acceptTimeStep();
    ++report_.nExchanges;
    report_.firstResidual = method_->statistics().firstResidual;
    report_.lastResidual = last.residual;
    report_.nColumns = method_->statistics().nColumns;
    report_.nIterations = structure_.nIterations();
    return last;
}

void FsiParticipant::rejectTimeStep() {
    integrator_.rejectTimeStep();
    method_->reject();
}

} // namespace tokay::structure
