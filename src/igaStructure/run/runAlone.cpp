#include "igaStructure/run/runAlone.hpp"

#include "common/errors.hpp"
#include "igaStructure/body/makeBody.hpp"
#include "igaStructure/run/Interruption.hpp"
#include "igaStructure/run/RunOutput.hpp"
#include "igaStructure/run/describeModel.hpp"

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

StepReport describeStep(int step, const TimeIntegrator& integrator) {
    StepReport report;
    report.step = step;
    report.nIterations = integrator.nIterations();
    report.lastResidual = integrator.residuals().empty() ? 0 : integrator.residuals().back();
    return report;
}

} // namespace

void runAlone(const Case& structureCase, const Report& report) {
    const TimeSteps steps = requireTimeSteps(structureCase);
    const std::unique_ptr<Body> body = makeBody(structureCase);
    report(describeModel(structureCase, *body));
    TimeIntegrator integrator(body->model(), structureCase.timeScheme, structureCase.newton, 0);
    RunOutput output(structureCase, *body, integrator.state(), steps.end, report);
    PhaseTimer timer;
    // A rest shorter than rounding error is no step.
    const int nSteps = static_cast<int>(std::ceil(steps.end / steps.step * (1 - 1e-12)));
    for (int step = 1; step <= nSteps; ++step) {
        throwIfInterrupted();
        const bool isLast = step == nSteps;
        const double time = isLast ? steps.end : step * steps.step;
        integrator.beginTimeStep(time, isLast ? time - (step - 1) * steps.step : steps.step);
        timer.time(Phase::solving, [&] {
            integrator.solve();
            integrator.acceptTimeStep();
        });
        const int interval = structureCase.output.interval;
        output.finishStep(describeStep(step, integrator), integrator, timer,
                          interval > 0 && (isLast || step % interval == 0));
    }
}

} // namespace tokay::structure
