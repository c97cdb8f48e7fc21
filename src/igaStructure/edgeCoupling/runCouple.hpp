// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/run/StepReport.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// What the command line says of two coupled structures.
struct CoupleOptions {
    std::vector<std::string> caseFiles; ///< of the two, in any order
    std::string address;           ///< of the loaded structure, running elsewhere; empty: starts it
    std::string tokenFile;         ///< with the secret shared with it; empty: none
    bool printsMassMatrix = false; ///< M_DD of the moved edges
    std::optional<double> restartTime; ///< of the saved states to go on from; none: at rest [s]
};

/// Runs two structures that are coupled along edges: displacement one way, forces back.
/// The one that is moved leads; the other one, which the forces load, holds the coupling
/// method, as beside a fluid.
/// @throws InputError, SolverError, OutputError, Interrupted, channel::PeerError
void runCouple(const CoupleOptions& options, const Report& report);

} // namespace tokay::structure
