// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"
#include "igaStructure/timeIntegration/MotionState.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tokay::structure {

/// All that a coupled run needs to go on from the end of a time step.
struct SavedState {
    std::string digest; ///< of what the unknowns mean; see Case::digest
    MotionState motion;
    Energies energies;
    geometry::Points interface;            ///< the fluid's points in the reference configuration
    Eigen::VectorXd interfaceDisplacement; ///< that the fluid has, a component a row [m]
    /// What motion.displacement differs from that by at the interface [m]
    Eigen::VectorXd interfaceResidual;
    std::vector<std::uint8_t> coupling; ///< predictor's and accelerator's, a row a component
    std::string file{};                 ///< that it was read from, for messages
};

/// Bytes of a state file: magic, version, time, then the rest; doubles as they
/// are, little-endian; at the end the checksum of all before it.
std::vector<std::uint8_t> encodeState(const SavedState& state);

/// @param name  of the file, for messages
/// @throws InputError if the bytes are not a whole state of this version, or a
///         single bit has changed
SavedState decodeState(const std::vector<std::uint8_t>& bytes, const std::string& name);

/// The error for a state that cannot be used.
[[noreturn]] void throwDamaged(const std::string& file, const std::string& reason);

} // namespace tokay::structure
