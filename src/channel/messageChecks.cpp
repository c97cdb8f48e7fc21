// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/messageChecks.hpp"

#include "channel/PeerError.hpp"
#include "channel/allFinite.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace tokay::channel {
namespace {

// No structure goes so many times its own size away; a flow would only overflow there.
constexpr double maxRelativeDisplacement = 1e6;

// A name and a version.
constexpr std::size_t longestName = 200;

std::string text(double value) {
    std::ostringstream stream;
    stream << value;
    return stream.str();
}

void requireLine(const std::string& name) {
    if (name.size() > longestName || name.find('\n') != std::string::npos) {
        throw PeerError("the name of its program is no short line");
    }
}

void requireFaces(const Interface& interface) {
    const auto& offsets = interface.faceOffsets;
    if (offsets.empty() || offsets.front() != 0 || offsets.back() != interface.facePoints.size() ||
        !std::is_sorted(offsets.begin(), offsets.end())) {
        throw PeerError("its faces are not cut properly from its list of points");
    }
    if (offsets.size() == 1) {
        throw PeerError("it has no faces");
    }
    const std::size_t nPoints = interface.points.size() / interface.dimension;
    for (const std::uint32_t point : interface.facePoints) {
        if (point >= nPoints) {
            throw PeerError("a face has point " + std::to_string(point) + " of " +
                            std::to_string(nPoints));
        }
    }
}

void requireFinite(const std::vector<double>& values, const std::string& what) {
    if (const auto index = firstNonFinite(values)) {
        throw PeerError(what + " is not finite, component " + std::to_string(*index) + " of " +
                        std::to_string(values.size()));
    }
}

// The tolerance is checked where the criteria are made, which explain it.
void requireTimes(const Interface& interface) {
    if (!allFinite({interface.startTime, interface.endTime})) {
        throw PeerError("it starts at " + text(interface.startTime) + " s and ends at " +
                        text(interface.endTime) + " s");
    }
    if (!std::isfinite(interface.deltaT) || interface.deltaT < 0) {
        throw PeerError("its time step is " + text(interface.deltaT) + " s");
    }
}

const char* nameOfState(State state) {
    constexpr std::array<const char*, 4> names = {"iterate", "converged", "accepted", "rejected"};
    return names.at(static_cast<std::size_t>(state));
}

/// A prediction is to be iterated, final forces end the step, unless they are to do so
/// only if it has converged.
bool allows(const Message& question, State state) {
    const auto* forces = std::get_if<Forces>(&question);
    if (!forces) {
        return state == State::iterate;
    }
    if (state == State::accepted) {
        return forces->final;
    }
    return state == State::rejected || !forces->final || forces->ifConverged;
}

std::string describeQuestion(const Message& question) {
    const auto* forces = std::get_if<Forces>(&question);
    return !forces ? "the begin of a time step" : forces->final ? "final forces" : "forces";
}

void requireDisplacements(const std::vector<double>& values, const Agreement& agreement) {
    if (values.size() != agreement.nValues) {
        throw PeerError("the structure sent " + std::to_string(values.size()) +
                        " displacement components where the interface has " +
                        std::to_string(agreement.nValues));
    }
    requireFinite(values, "the structure's displacement");
    const double limit = maxRelativeDisplacement * agreement.extent;
    for (const double value : values) {
        if (std::abs(value) > limit) {
            throw PeerError("the structure's displacement is " + text(value) +
                            " m at an interface of " + text(agreement.extent) + " m");
        }
    }
}

} // namespace

Agreement::Agreement(const Interface& interface)
    : nValues(interface.points.size()), tolerance(interface.tolerance) {
    for (std::size_t i = 0; i < nValues; ++i) {
        const std::size_t first = i % interface.dimension;
        extent = std::max(extent, std::abs(interface.points[i] - interface.points[first]));
    }
}

void requireConsistent(const Hello& hello) {
    requireLine(hello.program);
    requireLine(hello.caseDigest);
}

void requireConsistent(const Interface& interface) {
    if (interface.dimension != 2 && interface.dimension != 3) {
        throw PeerError("its dimension is " + std::to_string(interface.dimension));
    }
    if (interface.points.size() % interface.dimension != 0) {
        throw PeerError("its coordinates do not make whole points");
    }
    if (interface.displacements.size() != interface.points.size()) {
        throw PeerError("it has not one displacement a point");
    }
    requireFaces(interface);
    requireFinite(interface.points, "a coordinate of its points");
    requireFinite(interface.displacements, "a displacement of its points");
    requireTimes(interface);
}

void requireUsable(const Displacements& answer, const Message& question,
                   const Agreement& agreement) {
    if (!allows(question, answer.state)) {
        throw PeerError(std::string("the structure answered '") + nameOfState(answer.state) +
                        "' to " + describeQuestion(question));
    }
    if (answer.state == State::rejected) {
        return; // nothing of it is used but the reason
    }
    requireDisplacements(answer.values, agreement);
    // In this order: a solver that traps floating point exceptions compares no NaN.
    if (!std::isfinite(answer.residual) || answer.residual < 0) {
        throw PeerError("the structure's coupling residual is " + text(answer.residual));
    }
    const auto* forces = std::get_if<Forces>(&question);
    const bool hasConverged = answer.state == State::converged ||
                              (answer.state == State::accepted && forces && forces->ifConverged);
    if (hasConverged && !(answer.residual < agreement.tolerance)) {
        throw PeerError("the structure says that the step has converged, with a coupling residual "
                        "of " +
                        text(answer.residual) + " at a tolerance of " + text(agreement.tolerance));
    }
    if (answer.balance) {
        std::apply(
            [](const auto&... numbers) {
                requireFinite({numbers...}, "the structure's force, moment, power or swept volume");
            },
            numbersOf(*answer.balance));
    }
}

} // namespace tokay::channel
