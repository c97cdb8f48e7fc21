// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/step/CouplingOptions.hpp"

#include "common/errors.hpp"

#include <cmath>
#include <sstream>
#include <string>

namespace tokay::coupling {
namespace {

void require(bool valid, const std::string& name, double value, const std::string& allowed) {
    if (!valid) {
        std::ostringstream text;
        text << "the coupling option " << name << " is " << value << ": it must be " << allowed;
        throw InputError(text.str());
    }
}

void requireRelaxation(const std::string& name, double value) {
    require(value > 0 && value <= 2, name, value, "above 0 and at most 2");
}

void requireNotNegative(const std::string& name, double value) {
    require(value >= 0 && std::isfinite(value), name, value, "0 or positive");
}

void requireShare(const std::string& name, double value) {
    require(value >= 0 && value < 1, name, value, "at least 0 and below 1");
}

} // namespace

void requireValid(const CouplingOptions& options) {
    requireRelaxation("relaxation", options.relaxation);
    requireRelaxation("initialRelaxation", options.initialRelaxation);
    requireRelaxation("smallestRelaxation", options.smallestRelaxation);
    require(options.largestRelaxation >= options.smallestRelaxation &&
                std::isfinite(options.largestRelaxation),
            "largestRelaxation", options.largestRelaxation, "at least smallestRelaxation");
    require(options.reusedTimeSteps >= 0, "reusedTimeSteps", options.reusedTimeSteps,
            "0 or positive");
    require(options.largestColumns >= 1, "largestColumns", options.largestColumns, "positive");
    require(options.largestRank >= 2, "largestRank", options.largestRank, "at least 2");
    requireShare("rankLimit", options.rankLimit);
    requireShare("filterLimit", options.filterLimit);
    requireNotNegative("signalToNoise", options.signalToNoise);
    requireNotNegative("largestStep", options.largestStep);
    requireShare("keepFraction", options.keepFraction);
    requireShare("fluidMemory", options.fluidMemory);
    requireNotNegative("memoryContrast", options.memoryContrast);
    requireNotNegative("absoluteDisplacement", options.absoluteDisplacement);
    requireNotNegative("relativeForce", options.relativeForce);
    requireNotNegative("absoluteForce", options.absoluteForce);
}

} // namespace tokay::coupling
