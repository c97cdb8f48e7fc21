// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/restart/StartState.hpp"

#include "common/errors.hpp"
#include "igaStructure/coupledRun/restart/interfaceRenumbering.hpp"

#include <fmt/format.h>

namespace tokay::structure {

using channel::Interface;

namespace {

// Names of time folders have few digits: a state may be this part of a step off.
constexpr double startTimeTolerance = 0.1;

// The fluid's displacement is the saved one, but for the digits of its files.
constexpr double displacementTolerance = 1e-4;

// The mapping gives what it has given, but for options that hardly change it.
constexpr double mappingTolerance = 1e-3;

[[noreturn]] void throwNoState(const Interface& fluid, const StateFolder& folder) {
    const std::vector<double> times = folder.times();
    throw InputError(fmt::format(
        "the fluid starts at {:.9g} s with a displaced interface, but the structure has no saved "
        "state of that time in {}; it has: {}. Start the fluid from one of these times, or from an "
        "undeformed mesh",
        fluid.startTime, folder.directory(),
        times.empty() ? "none" : fmt::format("{:.9g} s", fmt::join(times, " s, "))));
}

// Largest difference between the displacements of the two sides, over their
// largest component.
double difference(const StartState& state, const Eigen::VectorXd& ofFluid) {
    const Eigen::VectorXd ofState = state.saved.interfaceDisplacement(state.components);
    const double scale =
        std::max(ofState.lpNorm<Eigen::Infinity>(), ofFluid.lpNorm<Eigen::Infinity>());
    return scale == 0 ? 0 : (ofState - ofFluid).lpNorm<Eigen::Infinity>() / scale;
}

} // namespace

StateFolder stateFolder(const Case& structureCase) {
    return {structureCase.output.directory + "/states", structureCase.name};
}

void requireSameStructure(const SavedState& state, const Case& structureCase, int nUnknowns) {
    if (state.motion.displacement.size() != nUnknowns) {
        throw InputError(fmt::format(
            "the saved state of {:.9g} s has {} unknowns, but {} makes {}: "
            "go on with the case file that it was made with, or start from "
            "an undeformed mesh",
            state.motion.time, state.motion.displacement.size(), structureCase.file, nUnknowns));
    }
    if (state.digest != structureCase.digest) {
        throw InputError(fmt::format(
            "geometry or discretisation of {} are not those of the saved state of {:.9g} s: go on "
            "with the case file that it was made with, or start from an undeformed mesh",
            structureCase.file, state.motion.time));
    }
}

std::optional<StartState> findStartState(const Case& structureCase, int nUnknowns,
                                         const geometry::Points& points, const Interface& fluid) {
    const StateFolder folder = stateFolder(structureCase);
    const Eigen::Map<const Eigen::VectorXd> ofFluid(
        fluid.displacements.data(), static_cast<Eigen::Index>(fluid.displacements.size()));
    const bool isDeformed = (ofFluid.array() != 0).any();
    std::optional<SavedState> saved =
        folder.find(fluid.startTime, startTimeTolerance * fluid.deltaT);
    if (!saved && isDeformed) {
        throwNoState(fluid, folder);
    }
    if (!saved) {
        return std::nullopt;
    }
    StartState state{std::move(*saved), {}};
    if (const auto numbers = interfaceRenumbering(state.saved.interface, points)) {
        state.components = componentNumbers(*numbers, static_cast<int>(fluid.dimension));
        const double distance = difference(state, ofFluid);
        if (distance > displacementTolerance && isDeformed) {
            throw InputError(fmt::format(
                "the fluid's interface at its start time {:.9g} s is not where the structure's "
                "saved state has it: displacements differ by {:.2g} of the largest one. Are both "
                "from the same run? Start from another time, or from an undeformed mesh",
                fluid.startTime, distance));
        }
        if (distance > displacementTolerance) {
            return std::nullopt; // what another run has left there
        }
    } else if (!isDeformed) {
        return std::nullopt;
    }
    requireSameStructure(state.saved, structureCase, nUnknowns);
    return state;
}

void requireConsistent(const StartState& state, const Eigen::VectorXd& mapped) {
    if (state.components.empty()) {
        return;
    }
    const Eigen::VectorXd saved = state.saved.interfaceDisplacement(state.components) +
                                  state.saved.interfaceResidual(state.components);
    const double scale =
        std::max(saved.lpNorm<Eigen::Infinity>(), mapped.lpNorm<Eigen::Infinity>());
    const double distance = (saved - mapped).lpNorm<Eigen::Infinity>();
    if (!(distance <= mappingTolerance * scale)) {
        throwDamaged(state.saved.file,
                     fmt::format("the structure's displacement is off the interface's by {:.2g} of "
                                 "the largest one (or coupling.mapping is another one now: go on "
                                 "with that of the run before)",
                                 distance / scale));
    }
}

} // namespace tokay::structure
