// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/TimeOptions.hpp"

#include <fmt/format.h>

#include <limits>

namespace tokay::structure {

namespace {

using Schemes = Choices<TimeOptions::Scheme, TimeOptions>;

const Schemes& schemes() {
    static const EntryOf<TimeOptions> minDeltaT = {
        "minDeltaT",
        &TimeOptions::minDeltaT,
        "(0, inf)",
        "s",
        "Run alone: a time step in which equilibrium is not found is halved, down to this length, "
        "and doubled again after success.",
        otherwise("`step`: never halved")};
    static const EntryOf<TimeOptions> substeps = {
        "substeps", &TimeOptions::substeps, "[1, inf)", "",
        "Coupled run: structural time steps per time step of the fluid, under the mean of the "
        "fluid's forces at its ends. More than 1 excludes the acceleration block; the default is "
        "then iqnIls."};
    static const Schemes choices = {
        {"generalisedAlpha",
         TimeOptions::generalisedAlpha,
         "Chung & Hulbert 1993, second order, dissipates high frequencies only.",
         {{"spectralRadius", &TimeOptions::spectralRadius, "[0, 1]", "",
           "Amplification of infinitely high frequencies; 1 keeps all energy, 0 annihilates them "
           "in one step."},
          minDeltaT,
          substeps}},
        {"newmark",
         TimeOptions::newmark,
         "Newmark's scheme; the default is the trapezoidal rule.",
         {{"beta", &TimeOptions::beta, "(0, 0.5]", "", "Newmark's beta."},
          {"gamma", &TimeOptions::gamma, "[0.5, 1]", "",
           "Newmark's gamma; larger values dissipate and reduce the order to 1."},
          minDeltaT,
          substeps}},
        {"static",
         TimeOptions::quasiStatic,
         "no inertia and no damping, one load step per time step.",
         {minDeltaT}},
        {"arcLength",
         TimeOptions::arcLength,
         "run alone, static: follows the equilibrium path through limit points; time is the load "
         "parameter and may decrease.",
         {{"maxSteps", &TimeOptions::maxSteps, "[1, inf)", "",
           "Maximum number of steps, if the path does not reach end before."},
          {"maxGrowth", &TimeOptions::maxGrowth, "[1, inf)", "",
           "Longest step along the path, over the first one. Steps are halved when they fail, "
           "and grow and shrink so that each takes about 5 Newton iterations."}}},
        {"explicit",
         TimeOptions::centralDifferences,
         "run alone: central differences with lumped mass; each time step is divided into the "
         "substeps that stability needs.",
         {}}};
    return choices;
}

} // namespace

const SchemaOf<TimeOptions>& TimeOptions::schema() {
    static const SchemaOf<TimeOptions> schema = {
        {"scheme", &TimeOptions::scheme, schemes(), "Time integration."},
        {"step", &TimeOptions::step, "(0, inf)", "s",
         "Time step of a run alone; a coupled run takes the fluid's. arcLength: the first step, "
         "whose change of displacement is the unit of the steps along the path.",
         otherwise("required for a run alone")},
        {"end", &TimeOptions::end, "(0, inf)", "s",
         "End time of a run alone, which starts at 0; a coupled run takes the fluid's.",
         otherwise("required for a run alone")}};
    return schema;
}

void TimeOptions::requireValid() const {
    if (step.has_value() != end.has_value()) {
        throw error("", fmt::format("entry '{}' is missing: a run alone needs step and end (a "
                                    "coupled run neither)",
                                    step ? "end" : "step"));
    }
    if (step && *end < *step) {
        throw error("end", fmt::format("{} s is shorter than one step of {} s", *end, *step));
    }
    if (step && scheme != arcLength && *end / *step > std::numeric_limits<int>::max()) {
        throw error("step",
                    fmt::format("{} s makes {:.3g} time steps to the end at {} s; allowed: "
                                "at most {}; take a larger step",
                                *step, *end / *step, *end, std::numeric_limits<int>::max()));
    }
    if (step && minDeltaT.value_or(*step) > *step) {
        throw error("minDeltaT",
                    fmt::format("{} s is longer than the step of {} s", *minDeltaT, *step));
    }
}

TimeIntegration TimeOptions::generalisedAlpha(const TimeOptions& options) {
    return TimeScheme::generalisedAlpha(options.spectralRadius);
}

TimeIntegration TimeOptions::newmark(const TimeOptions& options) {
    return TimeScheme::newmark(options.beta, options.gamma);
}

TimeIntegration TimeOptions::quasiStatic(const TimeOptions&) {
    return TimeScheme::quasiStatic();
}

TimeIntegration TimeOptions::arcLength(const TimeOptions& options) {
    return EquilibriumPath{options.maxSteps, options.maxGrowth};
}

TimeIntegration TimeOptions::centralDifferences(const TimeOptions&) {
    return CentralDifferences{};
}

} // namespace tokay::structure
