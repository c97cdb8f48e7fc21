// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluations of the fluid a step: methods x model problems x tolerances, with
// exact fluids, with white noise and with fluids that fall short of their
// answers. Usage: couplingMethods RESULTS.csv [quick]
#include "ElasticTube.hpp"
#include "Ring.hpp"
#include "coupledRun.hpp"
#include "coupling/block/BlockQuasiNewton.hpp"
#include "coupling/fixedPoint/IqnIls.hpp"
#include "coupling/fixedPoint/Mvqn.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace tokay::coupling;

namespace {

struct Problem {
    std::string name;
    std::function<std::unique_ptr<CoupledModel>()> make;
    /// Evaluations of the block method in the prototype of the design, at 1e-8.
    std::optional<double> designed;
};

std::unique_ptr<CoupledModel> tube() {
    return std::make_unique<ElasticTube>(40, 10, 0.01);
}

Problem ring(RingWall wall, double massRatio, std::optional<double> designed) {
    static const char* const walls[] = {"linear", "cubic", "geometric"};
    const std::string name = std::string(walls[static_cast<int>(wall)]) + " ring mu " +
                             std::to_string(static_cast<int>(massRatio));
    return {name, [=] { return std::make_unique<Ring>(wall, massRatio); }, designed};
}

const std::vector<Problem> problems = {{"tube", tube, 3.3},
                                       ring(RingWall::linear, 1, 3.4),
                                       ring(RingWall::linear, 100, 3.1),
                                       ring(RingWall::linear, 1000, 3.3),
                                       ring(RingWall::cubic, 1, {}),
                                       ring(RingWall::cubic, 100, 4.0),
                                       ring(RingWall::cubic, 1000, 4.1),
                                       ring(RingWall::geometric, 1, {}),
                                       ring(RingWall::geometric, 100, {}),
                                       ring(RingWall::geometric, 1000, 5.0)};

const std::vector<std::string> candidates = {"aitken", "iqnIls", "mvqn", "block"};

struct Setting {
    double tolerance;
    Imperfection imperfection;
};

std::vector<Setting> settings(bool quick) {
    if (quick) {
        return {{1e-8, {}}};
    }
    return {{1e-8, {}},        {1e-4, {}},       {1e-4, {1e-5, 0}},
            {1e-2, {1e-3, 0}}, {1e-4, {0, 0.1}}, {1e-4, {0, 0.3}}};
}

/// Defaults, but for the guards that cost iterations where nothing drifts (filterLimit: noise
/// that a difference is taken to have).
CouplingOptions optionsFor(const std::string& candidate, const Setting& setting) {
    CouplingOptions options;
    options.acceleration.type = candidate;
    auto& iqnIls = options.acceleration.of<IqnIls::Options>();
    iqnIls.keepFraction = 0;
    iqnIls.maxColumns = 100;
    options.acceleration.of<Mvqn::Options>().keepFraction = 0;
    auto& block = options.acceleration.of<BlockQuasiNewton::Options>();
    block.fluidMemory = setting.imperfection.memory;
    if (setting.imperfection.noise == 0 && setting.imperfection.memory == 0) {
        block.filterLimit = std::min(block.filterLimit, 1e-3);
    }
    return options;
}

/// "" where the design names no number.
std::string verdict(const Problem& problem, const std::string& candidate, const Setting& setting,
                    const RunResult& result) {
    const Imperfection& imperfection = setting.imperfection;
    if (candidate != "block" || !problem.designed || setting.tolerance != 1e-8 ||
        imperfection.noise > 0 || imperfection.memory > 0) {
        return "";
    }
    const bool good = result.nFailed + result.nFailedAtStart == 0 &&
                      result.meanEvaluations <= 1.2 * *problem.designed &&
                      result.largestError < 1.5 * setting.tolerance;
    return good ? "ok" : "MISSED";
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "Usage: couplingMethods RESULTS.csv [quick]\n");
        return 2;
    }
    std::FILE* file = std::fopen(argv[1], "w");
    if (!file) {
        std::fprintf(stderr, "Cannot write %s\n", argv[1]);
        return 2;
    }
    std::fprintf(file, "case,method,tolerance,noise,fluidMemory,evaluationsPerStep,"
                       "largestEvaluations,evaluationsOfFirstStep,failedSteps,failedStepsAtStart,"
                       "largestError,verdict\n");
    bool good = true;
    for (const Setting& setting : settings(argc > 2)) {
        const auto [noise, memory] = setting.imperfection;
        std::printf("\ntolerance %g, noise %g, memory %g: mean evaluations (failed steps of 100)\n",
                    setting.tolerance, noise, memory);
        for (const Problem& problem : problems) {
            std::printf("%-22s", problem.name.c_str());
            for (const std::string& candidate : candidates) {
                const auto model = problem.make();
                const RunResult result = coupledRun(*model, optionsFor(candidate, setting),
                                                    setting.tolerance, setting.imperfection);
                const std::string judged = verdict(problem, candidate, setting, result);
                good = good && judged != "MISSED";
                std::printf(" %s %5.2f (%3d)", candidate.c_str(), result.meanEvaluations,
                            result.nFailed);
                std::fprintf(file, "%s,%s,%.0e,%g,%g,%.2f,%d,%d,%d,%d,%.1e,%s\n",
                             problem.name.c_str(), candidate.c_str(), setting.tolerance, noise,
                             memory, result.meanEvaluations, result.largestEvaluations,
                             result.evaluationsOfFirstStep, result.nFailed, result.nFailedAtStart,
                             result.largestError, judged.c_str());
            }
            std::printf("\n");
            std::fflush(stdout);
        }
    }
    std::fclose(file);
    return good ? 0 : 1;
}
