// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/restart/SavedState.hpp"

#include "common/errors.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <fmt/format.h>

namespace tokay::structure {

using coupling::StateReader;
using coupling::StateWriter;

namespace {

const std::string magic = "TokayState";
constexpr int stateVersion = 3;

} // namespace

std::vector<std::uint8_t> encodeState(const SavedState& state) {
    std::vector<std::uint8_t> bytes;
    StateWriter write(bytes);
    write.text(magic);
    write.integer(stateVersion);
    write.number(state.motion.time);
    write.text(state.digest);
    for (const auto* vector : {&state.motion.displacement, &state.motion.velocity,
                               &state.motion.acceleration, &state.motion.force}) {
        write.matrix(*vector);
    }
    for (const double energy : {state.energies.kinetic, state.energies.strain,
                                state.energies.externalWork, state.energies.dampingWork}) {
        write.number(energy);
    }
    write.matrix(state.interface);
    write.matrix(state.interfaceDisplacement);
    write.integer(static_cast<int>(state.coupling.size()));
    bytes.insert(bytes.end(), state.coupling.begin(), state.coupling.end());
    return bytes;
}

SavedState decodeState(const std::vector<std::uint8_t>& bytes, const std::string& name) {
    SavedState state;
    try {
        StateReader read(bytes);
        if (read.text() != magic) {
            throw channel::PeerError("it does not begin as one");
        }
        if (const int version = read.integer(); version != stateVersion) {
            throw channel::PeerError(fmt::format("its version is {}, this program reads version "
                                                 "{}",
                                                 version, stateVersion));
        }
        state.motion.time = read.number();
        state.digest = read.text();
        for (auto* vector : {&state.motion.displacement, &state.motion.velocity,
                             &state.motion.acceleration, &state.motion.force}) {
            *vector = read.vector();
        }
        for (double* energy : {&state.energies.kinetic, &state.energies.strain,
                               &state.energies.externalWork, &state.energies.dampingWork}) {
            *energy = read.number();
        }
        const Eigen::MatrixXd interface = read.matrix();
        if (interface.cols() != 3) {
            throw channel::PeerError("its interface has no points");
        }
        state.interface = interface;
        state.interfaceDisplacement = read.vector();
        state.coupling.resize(static_cast<std::size_t>(read.integer()));
        if (state.coupling.size() != read.remaining()) {
            throw channel::PeerError("it is cut off, or something follows its end");
        }
    } catch (const channel::PeerError& error) {
        throw InputError(fmt::format("'{}' is not a state of a structure: {}; remove it, and start "
                                     "from another time",
                                     name, error.what()));
    }
    state.coupling.assign(bytes.end() - static_cast<std::ptrdiff_t>(state.coupling.size()),
                          bytes.end());
    return state;
}

} // namespace tokay::structure
