// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/runModes.hpp"

#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/output/ResultTable.hpp"
#include "igaStructure/run/ResultSeries.hpp"
#include "igaStructure/run/ResultsLock.hpp"
#include "igaStructure/run/describeModel.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay::structure {

namespace {

MotionState atRest(const StructuralModel& model) {
    MotionState state;
    state.displacement = Eigen::VectorXd::Zero(model.nUnknowns());
    state.velocity = state.acceleration = state.displacement;
    return state;
}

void writeShapes(const Case& structureCase, const Body& body, const NaturalModes& modes) {
    OutputOptions options = structureCase.output;
    options.fields = {"displacement"};
    MotionState state = atRest(body.model());
    ResultSeries series(body, options, structureCase.name + "Modes", state);
    for (Eigen::Index k = 0; k < modes.shapes.cols(); ++k) {
        const Eigen::VectorXd shape = modes.shapes.col(k);
        state.time = static_cast<double>(k + 1);
        state.displacement = 0.1 * body.model().size() / shape.lpNorm<Eigen::Infinity>() * shape;
        series.add(state);
    }
}

} // namespace

void runModes(const Case& structureCase, int count, const Report& report) {
    const std::unique_ptr<Body> body = makeBody(structureCase);
    report(describeModel(structureCase, *body));
    const ResultsLock lock(structureCase.output.directory, structureCase.name + "Modes", report);
    const NaturalModes modes = naturalModes(body->model(), count);
    ResultTable table(
        fmt::format("{}/postProcessing/{}/modes.dat", structureCase.directory, structureCase.name),
        {"mode", "angularFrequency[rad/s]", "frequency[Hz]"});
    for (Eigen::Index k = 0; k < modes.angularFrequencies.size(); ++k) {
        const double omega = modes.angularFrequencies[k];
        const double frequency = omega / (2 * M_PI);
        table.addRow({static_cast<double>(k + 1), omega, frequency});
        report(fmt::format("mode {}  {:.7g} rad/s  {:.7g} Hz", k + 1, omega, frequency));
    }
    writeShapes(structureCase, *body, modes);
}

} // namespace tokay::structure
