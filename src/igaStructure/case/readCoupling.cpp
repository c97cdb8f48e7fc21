// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/readCoupling.hpp"

#include "common/errors.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <variant>

namespace tokay::structure {

using coupling::CouplingOptions;

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
      "signalToNoise", "largestStep", "keepFraction"}},
    {"block",
     {"type", "initialRelaxation", "largestRank", "rankLimit", "filterLimit", "signalToNoise",
      "fluidMemory", "memoryContrast"}}};

const std::map<std::string, coupling::Acceleration> accelerations = {
    {"explicit", coupling::Acceleration::explicitCoupling},
    {"constant", coupling::Acceleration::constant},
    {"aitken", coupling::Acceleration::aitken},
    {"iqnIls", coupling::Acceleration::iqnIls},
    {"mvqn", coupling::Acceleration::mvqn},
    {"block", coupling::Acceleration::block}};

const std::map<std::string, coupling::Extrapolation> extrapolations = {
    {"constant", coupling::Extrapolation::constant},
    {"linear", coupling::Extrapolation::linear},
    {"quadratic", coupling::Extrapolation::quadratic},
    {"cubic", coupling::Extrapolation::cubic}};

const std::map<std::string, coupling::QrFilter> filters = {{"qr1", coupling::QrFilter::qr1},
                                                           {"qr2", coupling::QrFilter::qr2}};

/// An option of an acceleration that is a number.
struct NumberOption {
    std::string name;
    std::variant<double CouplingOptions::*, int CouplingOptions::*> member;
};

const std::vector<NumberOption> numberOptions = {
    {"relaxation", &CouplingOptions::relaxation},
    {"initialRelaxation", &CouplingOptions::initialRelaxation},
    {"smallestRelaxation", &CouplingOptions::smallestRelaxation},
    {"largestRelaxation", &CouplingOptions::largestRelaxation},
    {"reusedTimeSteps", &CouplingOptions::reusedTimeSteps},
    {"largestColumns", &CouplingOptions::largestColumns},
    {"largestRank", &CouplingOptions::largestRank},
    {"rankLimit", &CouplingOptions::rankLimit},
    {"filterLimit", &CouplingOptions::filterLimit},
    {"signalToNoise", &CouplingOptions::signalToNoise},
    {"largestStep", &CouplingOptions::largestStep},
    {"keepFraction", &CouplingOptions::keepFraction},
    {"fluidMemory", &CouplingOptions::fluidMemory},
    {"memoryContrast", &CouplingOptions::memoryContrast}};

void read(const CaseSection& section, const NumberOption& option, CouplingOptions& options) {
    if (const auto* real = std::get_if<double CouplingOptions::*>(&option.member)) {
        options.*(*real) = section.number(option.name);
    } else {
        options.*std::get<int CouplingOptions::*>(option.member) = section.integer(option.name);
    }
}

double value(const NumberOption& option, const CouplingOptions& options) {
    return std::visit([&](auto member) { return static_cast<double>(options.*member); },
                      option.member);
}

// The tangent of the block method is that of one step of the structure.
std::string readAccelerationType(const CaseSection& section, int substeps) {
    const std::string type = section.text("type");
    if (substeps == 1 || type != "block") {
        return type;
    }
    if (section.has("type")) {
        throw section.error("type", fmt::format("'block' does not go with time.substeps {}: its "
                                                "tangent is that of a single step; choose iqnIls "
                                                "or mvqn, or remove time.substeps",
                                                substeps));
    }
    return "iqnIls";
}

void readAcceleration(const CaseSection& section, int substeps, CouplingOptions& options) {
    const std::string type = readAccelerationType(section, substeps);
    requireUsed(section, optionsOfAcceleration.at(type), "acceleration type " + type);
    options.acceleration = accelerations.at(type);
    for (const NumberOption& option : numberOptions) {
        if (section.has(option.name)) {
            read(section, option, options);
        }
    }
    if (section.has("filter")) {
        options.filter = filters.at(section.text("filter"));
    }
}

/// The name that a table gives to a value.
template <class Value>
std::string nameOf(Value value, const std::map<std::string, Value>& names) {
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const auto& named) { return named.second == value; });
    assert(found != names.end());
    return found->first;
}

std::string describeSubsteps(int substeps) {
    return substeps == 1 ? ""
                         : fmt::format("\n  {} steps of the structure in one of the fluid, "
                                       "which excludes the acceleration block",
                                       substeps);
}

std::string describeAcceleration(const CouplingOptions& options) {
    const std::string type = nameOf(options.acceleration, accelerations);
    const std::vector<std::string>& names = optionsOfAcceleration.at(type);
    const auto isUsed = [&](const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::string text = type;
    for (const NumberOption& option : numberOptions) {
        if (isUsed(option.name)) {
            text += fmt::format(", {} {:g}", option.name, value(option, options));
        }
    }
    return isUsed("filter") ? text + ", filter " + nameOf(options.filter, filters) : text;
}

const std::map<std::string, TransferMethod> transferMethods = {
    {"nearestElement", TransferMethod::nearestElement}, {"offset", TransferMethod::offset}};

bool isThin(const std::string& kinematics) {
    return kinematics != "planeStrain" && kinematics != "planeStress" && kinematics != "solid";
}

void readMapping(const std::string& kinematics, const CaseSection& section, Coupling& coupling) {
    const CaseSection mapping = section.section("mapping");
    coupling.method = isThin(kinematics) ? TransferMethod::offset : TransferMethod::nearestElement;
    coupling.gapLimit = isThin(kinematics) ? 0.1 : 0.01;
    if (mapping.has("gapLimit")) {
        coupling.gapLimit = mapping.number("gapLimit");
    }
    const std::string type = nameOf(coupling.method, transferMethods);
    if (mapping.has("type") && mapping.text("type") != type) {
        throw mapping.error("type", fmt::format("'{}' has no meaning with {}, which takes {}",
                                                mapping.text("type"), kinematics, type));
    }
    if (isThin(kinematics) && section.has("interface")) {
        throw section.error("interface", fmt::format("has no meaning with {}, all of which is "
                                                     "wet; remove it",
                                                     kinematics));
    }
    if (!isThin(kinematics)) {
        const bool isSolid = kinematics == "solid";
        section.require("interface", fmt::format("{} needs the names of its wet {}", kinematics,
                                                 isSolid ? "faces" : "edges"));
        coupling.interface =
            isSolid ? section.words("interface")
                    : section.words("interface", {"left", "right", "bottom", "top"}, kinematics);
    }
}

} // namespace

Coupling readCoupling(const CaseSection& file) {
    const CaseSection section = file.section("coupling");
    Coupling result;
    readMapping(file.section("model").text("kinematics"), section, result);
    result.options.extrapolation = extrapolations.at(section.text("predictor"));
    result.substeps = file.section("time").integer("substeps");
    readAcceleration(section.section("acceleration"), result.substeps, result.options);
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

std::string describeCoupling(const Coupling& coupling) {
    const CouplingOptions& options = coupling.options;
    return fmt::format("coupling: interface {}, {}, gap limit {:g}\n"
                       "  predictor {}\n"
                       "  acceleration {}{}\n"
                       "  absolute displacement {:g} m, relative force {:g}, absolute force {:g}\n",
                       coupling.interface.empty()
                           ? "the whole body"
                           : fmt::format("{}", fmt::join(coupling.interface, " ")),
                       coupling.method == TransferMethod::offset ? "offset" : "nearest element",
                       coupling.gapLimit, nameOf(options.extrapolation, extrapolations),
                       describeAcceleration(options), describeSubsteps(coupling.substeps),
                       options.absoluteDisplacement, options.relativeForce, options.absoluteForce);
}

} // namespace tokay::structure
