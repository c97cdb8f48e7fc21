// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/RunOutput.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay::structure {

namespace {

using Clock = std::chrono::steady_clock;

double secondsBetween(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

// As OpenFOAM: postProcessing/<name>/<startTime>/<table>.dat
std::string tablePath(const Case& structureCase, double startTime, const std::string& table) {
    return fmt::format("{}/postProcessing/{}/{:g}/{}.dat", structureCase.directory,
                       structureCase.name, startTime, table);
}

std::vector<std::string> withTime(const std::vector<std::string>& columns) {
    std::vector<std::string> result = {"time[s]"};
    result.insert(result.end(), columns.begin(), columns.end());
    return result;
}

std::vector<double> withTime(double time, const std::vector<double>& values) {
    std::vector<double> row = {time};
    row.insert(row.end(), values.begin(), values.end());
    return row;
}

std::string duration(double seconds) {
    const auto whole = std::llround(seconds);
    if (whole >= 3600) {
        return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
    }
    return whole >= 60 ? fmt::format("{} min {:02} s", whole / 60, whole % 60)
                       : fmt::format("{} s", whole);
}

} // namespace

RunOutput::RunOutput(const Case& structureCase, const Body& body, const MotionState& start,
                     double endTime, Report report)
    : lock_(structureCase.output.directory, structureCase.name, report),
      watch_(body, structureCase.output.watchPoints),
      reactions_(body, structureCase.output.reactionsAbout),
      results_(body, structureCase.output, structureCase.name, start),
      watchTable_(tablePath(structureCase, start.time, "watchPoints"), withTime(watch_.columns())),
      reactionTable_(tablePath(structureCase, start.time, "reactions"),
                     withTime(reactions_.names())),
      iterationTable_(tablePath(structureCase, start.time, "iterations"),
                      {"time[s]", "exchanges", "firstResidual", "lastResidual", "columns",
                       "newtonIterations", "total[s]", "waiting[s]", "mapping[s]", "solving[s]",
                       "acceleration[s]", "output[s]", "cpu[s]"}),
      energyTable_(tablePath(structureCase, start.time, "energy"),
                   {"time[s]", "kinetic[J]", "strain[J]", "externalWork[J]", "dampingWork[J]"}),
      startTime_(start.time), endTime_(endTime), report_(std::move(report)), start_(Clock::now()),
      stepStart_(start_), processorStart_(std::clock()) {}

void RunOutput::finishStep(const StepReport& step, const MotionState& state,
                           const Energies& energies, PhaseTimer& timer, bool writeResults) {
    if (writeResults) {
        const auto timed = timer.enter(Phase::output);
        results_.add(state);
    }
    const Clock::time_point now = Clock::now();
    const double seconds = secondsBetween(stepStart_, now);
    stepStart_ = now;
    const std::clock_t processor = std::clock();
    const double processorSeconds =
        static_cast<double>(processor - processorStart_) / CLOCKS_PER_SEC;
    processorStart_ = processor;
    const Clock::time_point tablesStart = Clock::now();
    writeTables(step, state, energies, timer, seconds, processorSeconds);
    report_(logLine(step, state, seconds));
    timer.reset();
    timer.add(Phase::output, secondsBetween(tablesStart, Clock::now()));
}

void RunOutput::writeTables(const StepReport& step, const MotionState& state,
                            const Energies& energies, const PhaseTimer& timer, double seconds,
                            double processorSeconds) {
    if (!watch_.isEmpty()) {
        watchTable_.addRow(withTime(state.time, watch_.values(state.displacement)));
    }
    if (!reactions_.isEmpty()) {
        reactionTable_.addRow(withTime(state.time, reactions_.values(state)));
    }
    iterationTable_.addRow({state.time, static_cast<double>(step.nExchanges), step.firstResidual,
                            step.lastResidual, static_cast<double>(step.nColumns),
                            static_cast<double>(step.nIterations), seconds,
                            timer.seconds(Phase::waiting), timer.seconds(Phase::mapping),
                            timer.seconds(Phase::solving), timer.seconds(Phase::acceleration),
                            timer.seconds(Phase::output), processorSeconds});
    energyTable_.addRow({state.time, energies.kinetic, energies.strain, energies.externalWork,
                         energies.dampingWork});
}

std::string RunOutput::logLine(const StepReport& step, const MotionState& state,
                               double seconds) const {
    const double done = (state.time - startTime_) / (endTime_ - startTime_);
    std::string line = fmt::format("step {} time {:.6g} s", step.step, state.time);
    if (step.nExchanges > 0) {
        line += fmt::format("  exchanges {} residual {:.2e}", step.nExchanges, step.lastResidual);
    } else {
        line += fmt::format("  iterations {} residual {:.2e}", step.nIterations, step.lastResidual);
    }
    if (!step.note.empty()) {
        line += "  " + step.note;
    }
    if (!watch_.isEmpty()) {
        line += "  " + watch_.text(state.displacement);
    }
    line += fmt::format("  {:.3f} s/step", seconds);
    if (done > 0) { // on an equilibrium path time may fall below the start
        const double toGo = secondsBetween(start_, stepStart_) * (1 - done) / done;
        line += fmt::format(", {} to go", duration(std::max(0.0, toGo)));
    }
    return line;
}

} // namespace tokay::structure
