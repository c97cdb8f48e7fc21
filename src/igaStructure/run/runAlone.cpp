// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/runAlone.hpp"

#include "common/errors.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/run/Interruption.hpp"
#include "igaStructure/run/RunOutput.hpp"
#include "igaStructure/run/describeModel.hpp"
#include "igaStructure/run/requireSupports.hpp"
#include "igaStructure/timeIntegration/ArcLength.hpp"
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/ImplicitStepper.hpp"

#include <fmt/format.h>

#include <memory>

namespace tokay::structure {

namespace {

TimeSteps requireTimeSteps(const Case& structureCase) {
    if (!structureCase.timeSteps) {
        throw InputError(structureCase.file +
                         ": time: entries 'step' and 'end' are missing: a run alone needs them "
                         "(a coupled run is started by the fluid, or with --listen)");
    }
    return *structureCase.timeSteps;
}

/// A stepper and the largest number of its steps.
struct Advance {
    std::unique_ptr<Stepper> stepper;
    int maxSteps;
};

// A new time integration adds its own overload.
Advance makeAdvance(const TimeScheme& scheme, const Case& structureCase, const TimeSteps& steps,
                    StructuralModel& model, const Report& /*report*/) {
    return {std::make_unique<ImplicitStepper>(model, scheme, structureCase.newton, steps.minDeltaT),
            steps.count()};
}

Advance makeAdvance(const CentralDifferences& /*scheme*/, const Case& /*structureCase*/,
                    const TimeSteps& steps, StructuralModel& model, const Report& report) {
    auto integrator = std::make_unique<ExplicitIntegrator>(model, 0);
    report(fmt::format("  explicit: stable step about {:.3g} s\n",
                       integrator->stableStep(integrator->state().displacement)));
    return {std::move(integrator), steps.count()};
}

Advance makeAdvance(const EquilibriumPath& path, const Case& structureCase, const TimeSteps& steps,
                    StructuralModel& model, const Report& /*report*/) {
    return {std::make_unique<ArcLength>(model, structureCase.newton, path, steps.step, steps.end),
            path.maxSteps};
}

} // namespace

void runAlone(const Case& structureCase, const Report& report) {
    const TimeSteps steps = requireTimeSteps(structureCase);
    const std::unique_ptr<Body> body = makeBody(structureCase);
    report(describeModel(structureCase, *body));
    requireSupports(structureCase, body->model());
    const Advance advance = std::visit(
        [&](const auto& scheme) {
            return makeAdvance(scheme, structureCase, steps, body->model(), report);
        },
        structureCase.timeScheme);
    Stepper& stepper = *advance.stepper;
    RunOutput output(structureCase, *body, stepper.state(), steps.end, report);
    PhaseTimer timer;
    bool isLast = false;
    for (int step = 1; !isLast; ++step) {
        throwIfInterrupted();
        const bool mayBeShort = step == advance.maxSteps;
        const double time = mayBeShort ? steps.end : step * steps.step;
        const double deltaT = mayBeShort ? time - (step - 1) * steps.step : steps.step;
        const StepEffort effort =
            timer.time(Phase::solving, [&] { return stepper.advance(time, deltaT); });
        isLast = step == advance.maxSteps || stepper.state().time >= steps.end;
        StepReport stepReport;
        stepReport.step = step;
        stepReport.nIterations = effort.nIterations;
        stepReport.lastResidual = effort.residual;
        stepReport.note = effort.note;
        output.finishStep(stepReport, stepper.state(), stepper.energies(), timer,
                          structureCase.output.writesAt(step, isLast));
    }
    if (const double time = stepper.state().time; time < steps.end) {
        report(fmt::format("warning: the path has taken all its {} steps (time.maxSteps) and is at "
                           "t = {:g}; time.end {:g} is not reached",
                           advance.maxSteps, time, steps.end));
    }
}

} // namespace tokay::structure
