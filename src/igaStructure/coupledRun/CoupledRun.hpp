// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"
#include "igaStructure/case/Case.hpp"
#include "igaStructure/run/StepReport.hpp"

#include <string>

namespace tokay::structure {

/// What the command line says about a coupled run.
struct CoupledRunOptions {
    std::string recordFile;      ///< writes accepted interface displacements; empty: not
    std::string replayFile;      ///< answers these instead of solving; empty: solves
    double silenceInterval = 60; ///< a silent fluid is reported this often [s]
};

/// Reads a case that can be coupled.
/// @throws InputError for the first mistake, and if coupling or an implicit scheme is missing
Case readCoupledCase(const std::string& caseFile);

/// Reads a case that forces load at its interface, as beside a fluid.
/// @throws InputError also if another structure moves it
Case readLoadedCase(const std::string& caseFile);

/// What the structure says of itself in a handshake.
channel::Hello structureGreeting();

/// Runs a case coupled to the fluid at the other end of a channel, until that
/// says goodbye. Shakes hands first, unless that has been done. If the run fails, even by a mistake
/// in the case file, the fluid is told why.
/// @throws InputError, SolverError, OutputError, Interrupted, channel::PeerError
void runCoupled(const std::string& caseFile, channel::Channel channel,
                const CoupledRunOptions& options, const Report& report);

} // namespace tokay::structure
