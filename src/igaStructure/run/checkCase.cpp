// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/checkCase.hpp"

#include "common/dense/blas.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/run/Watch.hpp"
#include "igaStructure/run/advise.hpp"
#include "igaStructure/run/describeModel.hpp"
#include "igaStructure/run/requireSupports.hpp"
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

std::string describeSolver(const Case& structureCase, StructuralModel& model) {
    if (std::holds_alternative<CentralDifferences>(structureCase.timeScheme)) {
        ExplicitIntegrator integrator(model, 0);
        return fmt::format("  explicit: stable step about {:.3g} s\n",
                           integrator.stableStep(integrator.state().displacement));
    }
    const TimeScheme* scheme = structureCase.implicitScheme();
    const TimeIntegrator integrator(model, scheme ? *scheme : TimeScheme::quasiStatic(),
                                    structureCase.newton, 0);
    return fmt::format("  memory: {:.3g} MB for matrices, {:.3g} million entries in the factor\n"
                       "  linear algebra: {} on {}\n",
                       integrator.bytes() / 1e6, integrator.solver().nFactorEntries() / 1e6,
                       integrator.solver().name(), blasLibrary());
}

std::string describeUse(const Case& structureCase) {
    std::string text;
    if (structureCase.timeSteps) {
        text += fmt::format("  alone: to {:g} s by steps of {:g} s\n", structureCase.timeSteps->end,
                            structureCase.timeSteps->step);
    }
    if (structureCase.coupling) {
        text += describeCoupling(*structureCase.coupling);
    }
    return text;
}

std::string warnings(const Case& structureCase, const Body& body) {
    std::string text;
    if (!structureCase.coupling && !structureCase.timeSteps) {
        text += "warning: there is neither coupling nor time.step and time.end: it cannot run\n";
    }
    if (structureCase.coupling && structureCase.timeSteps) {
        text += "note: a coupled run takes time steps and end from the fluid; time.step and "
                "time.end are for a run alone\n";
    }
    const std::vector<std::string> free = body.model().freeRigidMotions();
    if (!free.empty()) {
        text += fmt::format("warning: supports do not prevent: {}\n", fmt::join(free, ", "));
    }
    if (blasLibrary().find("openblas") == std::string::npos) {
        text += fmt::format("warning: slow linear algebra ({}); install libopenblas-dev\n",
                            blasLibrary());
    }
    if (!blasKnowsProcessor()) {
        text += "warning: slow linear algebra: OpenBLAS does not know this processor and takes it "
                "for a Prescott; export OPENBLAS_CORETYPE=Haswell, or SkylakeX if it has AVX-512\n";
    }
    return text;
}

} // namespace

std::string checkCase(const Case& structureCase) {
    const std::unique_ptr<Body> body = makeBody(structureCase);
    const Watch watch(*body, structureCase.output.watchPoints);
    body->fields(structureCase.output.fields);
    requireSupports(structureCase, body->model());
    return describeModel(structureCase, *body) + describeSolver(structureCase, body->model()) +
           describeUse(structureCase) + warnings(structureCase, *body) +
           advise(structureCase, *body);
}

} // namespace tokay::structure
