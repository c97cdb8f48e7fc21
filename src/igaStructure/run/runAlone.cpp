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

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// Adds to the report what a solution took.
void count(const TimeIntegrator& integrator, StepReport& report) {
    report.nIterations += integrator.nIterations();
    report.lastResidual = integrator.residuals().empty() ? 0 : integrator.residuals().back();
}

// The state at a time, by one step of length deltaT, or by parts of it where
// equilibrium is not found in one.
void advanceTo(double time, double deltaT, double smallestStep, TimeIntegrator& integrator,
               StepReport& report) {
    double step = deltaT;
    while (true) {
        const double rest = step < deltaT ? time - integrator.state().time : deltaT;
        const bool isLast = step >= rest * (1 - 1e-12);
        integrator.beginTimeStep(isLast ? time : integrator.state().time + step,
                                 isLast ? rest : step);
        try {
            integrator.solve();
        } catch (const SolverError&) {
            integrator.rejectTimeStep();
            step *= 0.5;
            if (step < smallestStep) {
                throw;
            }
            continue;
        }
        integrator.acceptTimeStep();
        count(integrator, report);
        if (isLast) {
            return;
        }
        step = std::min(2 * step, 0.5 * deltaT); // whole steps have failed
    }
}

// A rest shorter than rounding error is no step.
int numberOfSteps(const TimeSteps& steps) {
    return static_cast<int>(std::ceil(steps.end / steps.step * (1 - 1e-12)));
}

bool writesResults(const Case& structureCase, int step, bool isLast) {
    const int interval = structureCase.output.interval;
    return interval > 0 && (isLast || step % interval == 0);
}

void runTimeSteps(const Case& structureCase, const TimeSteps& steps, Body& body,
                  const Report& report) {
    TimeIntegrator integrator(body.model(), structureCase.timeScheme, structureCase.newton, 0);
    RunOutput output(structureCase, body, integrator.state(), steps.end, report);
    PhaseTimer timer;
    const int nSteps = numberOfSteps(steps);
    for (int step = 1; step <= nSteps; ++step) {
        throwIfInterrupted();
        const bool isLast = step == nSteps;
        StepReport stepReport;
        stepReport.step = step;
        timer.time(Phase::solving, [&] {
            const double time = isLast ? steps.end : step * steps.step;
            advanceTo(time, isLast ? time - (step - 1) * steps.step : steps.step,
                      steps.smallestStep, integrator, stepReport);
        });
        output.finishStep(stepReport, integrator.state(), integrator.energies(), timer,
                          writesResults(structureCase, step, isLast));
    }
}

void runExplicit(const Case& structureCase, const TimeSteps& steps, Body& body,
                 const Report& report) {
    ExplicitIntegrator integrator(body.model(), 0);
    report(fmt::format("  explicit: stable step about {:.3g} s\n",
                       integrator.stableStep(integrator.state().displacement)));
    RunOutput output(structureCase, body, integrator.state(), steps.end, report);
    PhaseTimer timer;
    const int nSteps = numberOfSteps(steps);
    for (int step = 1; step <= nSteps; ++step) {
        throwIfInterrupted();
        const bool isLast = step == nSteps;
        timer.time(Phase::solving,
                   [&] { integrator.advance(isLast ? steps.end : step * steps.step); });
        StepReport stepReport;
        stepReport.step = step;
        stepReport.nIterations = integrator.nParts();
        output.finishStep(stepReport, integrator.state(), integrator.energies(), timer,
                          writesResults(structureCase, step, isLast));
    }
}

void runPath(const Case& structureCase, const TimeSteps& steps, Body& body, const Report& report) {
    ArcLength path(body.model(), structureCase.newton, steps.step);
    RunOutput output(structureCase, body, path.state(), steps.end, report);
    PhaseTimer timer;
    for (int step = 1; step <= steps.largestPathSteps && path.state().time < steps.end; ++step) {
        throwIfInterrupted();
        timer.time(Phase::solving, [&] { path.advance(); });
        StepReport stepReport;
        stepReport.step = step;
        stepReport.nIterations = path.nIterations();
        stepReport.lastResidual = path.residual();
        Energies energies;
        energies.strain = path.strainEnergy();
        energies.externalWork = path.externalWork();
        const bool isLast = step == steps.largestPathSteps || path.state().time >= steps.end;
        output.finishStep(stepReport, path.state(), energies, timer,
                          writesResults(structureCase, step, isLast));
    }
}

} // namespace

void runAlone(const Case& structureCase, const Report& report) {
    const TimeSteps steps = requireTimeSteps(structureCase);
    const std::unique_ptr<Body> body = makeBody(structureCase);
    report(describeModel(structureCase, *body));
    requireSupports(structureCase, body->model());
    if (steps.largestPathSteps > 0) {
        runPath(structureCase, steps, *body, report);
    } else if (steps.isExplicit) {
        runExplicit(structureCase, steps, *body, report);
    } else {
        runTimeSteps(structureCase, steps, *body, report);
    }
}

} // namespace tokay::structure
