#include "igaStructure/caseFile/readCoupling.hpp"

#include "common/errors.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"

#include <algorithm>
#include <cassert>
#include <map>

namespace tokay::structure {

namespace {

const std::map<std::string, std::vector<std::string>> optionsOfAcceleration = {
    {"explicit", {"type"}},
    {"constant", {"type", "relaxation"}},
    {"aitken", {"type", "initialRelaxation", "smallestRelaxation", "largestRelaxation"}},
    {"iqnIls",
     {"type", "initialRelaxation", "reusedTimeSteps", "largestColumns", "filter", "filterLimit",
      "signalToNoise", "largestStep", "keepFraction"}},
    {"mvqn",
     {"type", "initialRelaxation", "largestRank", "rankLimit", "filter", "filterLimit",
      "signalToNoise", "largestStep", "keepFraction"}}};

const std::map<std::string, coupling::Acceleration> accelerations = {
    {"explicit", coupling::Acceleration::explicitCoupling},
    {"constant", coupling::Acceleration::constant},
    {"aitken", coupling::Acceleration::aitken},
    {"iqnIls", coupling::Acceleration::iqnIls},
    {"mvqn", coupling::Acceleration::mvqn}};

const std::map<std::string, coupling::Extrapolation> extrapolations = {
    {"constant", coupling::Extrapolation::constant},
    {"linear", coupling::Extrapolation::linear},
    {"quadratic", coupling::Extrapolation::quadratic}};

void readIfGiven(const CaseSection& section, const char* name, double& value) {
    if (section.has(name)) {
        value = section.number(name);
    }
}

void readIfGiven(const CaseSection& section, const char* name, int& value) {
    if (section.has(name)) {
        value = section.integer(name);
    }
}

void readAcceleration(const CaseSection& section, coupling::CouplingOptions& options) {
    const std::string type = section.text("type");
    requireUsed(section, optionsOfAcceleration.at(type), "acceleration type " + type);
    options.acceleration = accelerations.at(type);
    readIfGiven(section, "relaxation", options.relaxation);
    readIfGiven(section, "initialRelaxation", options.initialRelaxation);
    readIfGiven(section, "smallestRelaxation", options.smallestRelaxation);
    readIfGiven(section, "largestRelaxation", options.largestRelaxation);
    readIfGiven(section, "reusedTimeSteps", options.reusedTimeSteps);
    readIfGiven(section, "largestColumns", options.largestColumns);
    readIfGiven(section, "largestRank", options.largestRank);
    readIfGiven(section, "rankLimit", options.rankLimit);
    readIfGiven(section, "filterLimit", options.filterLimit);
    readIfGiven(section, "signalToNoise", options.signalToNoise);
    readIfGiven(section, "largestStep", options.largestStep);
    readIfGiven(section, "keepFraction", options.keepFraction);
    if (section.has("filter")) {
        options.filter =
            section.text("filter") == "qr1" ? coupling::QrFilter::qr1 : coupling::QrFilter::qr2;
    }
}

} // namespace

Coupling readCoupling(const CaseSection& section) {
    Coupling result;
    for (const std::string& edge : section.words("interface")) {
        result.interface.push_back(geometry::edgeFromName(edge));
    }
    result.gapLimit = section.section("mapping").number("gapLimit");
    result.options.extrapolation = extrapolations.at(section.text("predictor"));
    readAcceleration(section.section("acceleration"), result.options);
    const CaseSection convergence = section.section("convergence");
    result.options.absoluteDisplacement = convergence.number("absoluteDisplacement");
    result.options.relativeForce = convergence.number("relativeForce");
    result.options.absoluteForce = convergence.number("absoluteForce");
    try {
        coupling::requireValid(result.options);
    } catch (const InputError& error) {
        throw section.error("", error.what()); // options that exclude each other
    }
    return result;
}

std::string nameOf(coupling::Acceleration acceleration) {
    const auto found =
        std::find_if(accelerations.begin(), accelerations.end(),
                     [&](const auto& named) { return named.second == acceleration; });
    assert(found != accelerations.end());
    return found->first;
}

} // namespace tokay::structure
