// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/restart/SavedState.hpp"

#include "common/checksum.hpp"
#include "common/errors.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

using coupling::StateReader;
using coupling::StateWriter;

namespace {

const std::string magic = "TokayState";
constexpr int stateVersion = 5;

constexpr std::size_t checksumSize = sizeof(std::uint32_t);

/// Before anything of it is believed; older versions have no checksum.
void requireWhole(const std::vector<std::uint8_t>& bytes) {
    StateReader read(bytes);
    if (read.text() != magic) {
        throw channel::PeerError("it does not begin as one");
    }
    if (const int version = read.integer(); version != stateVersion) {
        throw channel::PeerError(
            fmt::format("its version is {}, this program reads version {}", version, stateVersion));
    }
    const std::size_t size = bytes.size() - std::min(bytes.size(), checksumSize);
    const std::vector<std::uint8_t> end(bytes.begin() + static_cast<std::ptrdiff_t>(size),
                                        bytes.end());
    if (static_cast<std::uint32_t>(StateReader(end).integer()) != checksum(bytes.data(), size)) {
        throw channel::PeerError("it does not fit its checksum");
    }
}

void requireOneSize(const MotionState& motion) {
    for (const auto* vector :
         {&motion.velocity, &motion.acceleration, &motion.force, &motion.reaction}) {
        if (vector->size() != motion.displacement.size()) {
            throw channel::PeerError("its displacement, velocity, acceleration, force and reaction "
                                     "have different lengths");
        }
    }
}

} // namespace

std::vector<std::uint8_t> encodeState(const SavedState& state) {
    std::vector<std::uint8_t> bytes;
    StateWriter write(bytes);
    write.text(magic);
    write.integer(stateVersion);
    write.number(state.motion.time);
    write.text(state.digest);
    for (const auto* vector :
         {&state.motion.displacement, &state.motion.velocity, &state.motion.acceleration,
          &state.motion.force, &state.motion.reaction}) {
        write.matrix(*vector);
    }
    for (const double energy : {state.energies.kinetic, state.energies.strain,
                                state.energies.externalWork, state.energies.dampingWork}) {
        write.number(energy);
    }
    write.matrix(state.interface);
    write.matrix(state.interfaceDisplacement);
    write.matrix(state.interfaceResidual);
    write.integer(static_cast<int>(state.coupling.size()));
    bytes.insert(bytes.end(), state.coupling.begin(), state.coupling.end());
    write.integer(static_cast<int>(checksum(bytes.data(), bytes.size())));
    return bytes;
}

namespace {

SavedState readState(const std::vector<std::uint8_t>& bytes) {
    requireWhole(bytes);
    SavedState state;
    StateReader read(bytes);
    read.text();
    read.integer();
    state.motion.time = read.number();
    state.digest = read.text();
    for (auto* vector : {&state.motion.displacement, &state.motion.velocity,
                         &state.motion.acceleration, &state.motion.force, &state.motion.reaction}) {
        *vector = read.vector();
    }
    requireOneSize(state.motion);
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
    state.interfaceResidual = read.vector();
    if (state.interfaceResidual.size() != state.interfaceDisplacement.size()) {
        throw channel::PeerError("the displacements of its interface have different lengths");
    }
    const int size = read.integer();
    if (size < 0 || static_cast<std::size_t>(size) + checksumSize != read.remaining()) {
        throw channel::PeerError("it is cut off, or something follows its end");
    }
    const auto end = bytes.end() - static_cast<std::ptrdiff_t>(checksumSize);
    state.coupling.assign(end - size, end);
    return state;
}

} // namespace

SavedState decodeState(const std::vector<std::uint8_t>& bytes, const std::string& name) {
    try {
        SavedState state = readState(bytes);
        state.file = name;
        return state;
    } catch (const channel::PeerError& error) {
        throwDamaged(name, error.what());
    }
}

void throwDamaged(const std::string& file, const std::string& reason) {
    throw InputError(fmt::format("'{}': the state is damaged, or is none of this program: {}; "
                                 "remove it, and start from another time",
                                 file, reason));
}

} // namespace tokay::structure
