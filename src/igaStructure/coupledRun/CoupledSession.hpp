// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"
#include "igaStructure/case/Case.hpp"
#include "igaStructure/coupledRun/CoupledParticipant.hpp"
#include "igaStructure/coupledRun/CoupledRun.hpp"
#include "igaStructure/coupledRun/DisplacementRecord.hpp"
#include "igaStructure/coupledRun/FluidLink.hpp"
#include "igaStructure/coupledRun/WetBoundary.hpp"
#include "igaStructure/run/PhaseTimer.hpp"

#include <memory>
#include <optional>

namespace tokay::structure {

/// The session with the fluid: which message follows which, and what a message
/// must be before anything uses it.
class CoupledSession {
  public:
    /// Borrows the case, the link and the options.
    CoupledSession(const Case& structureCase, FluidLink& link, const CoupledRunOptions& options,
                   Report report);

    /// Until the fluid says goodbye.
    /// @throws InputError, SolverError, OutputError, Interrupted, channel::PeerError
    void run();

  private:
    void start();
    std::string checkCoverage() const;
    std::optional<channel::BeginStep> nextStep();
    void advance(const channel::BeginStep& begin);
    void finishTimeStep(const StructureResponse& response);
    std::optional<channel::Forces> nextForces();
    StructureResponse respondTo(const channel::Forces& forces);
    channel::Message receive(const std::string& waitingFor);
    void send(channel::State state, const StructureResponse& response);

    const Case& case_;
    FluidLink& link_;
    const CoupledRunOptions& options_;
    Report report_;
    std::unique_ptr<Body> body_;
    PhaseTimer timer_;
    std::optional<WetBoundary> boundary_;
    std::unique_ptr<CoupledParticipant> participant_;
    std::optional<DisplacementRecorder> recorder_;
    bool fluidRetries_ = false;
    int step_ = 0;
    double time_ = 0;
    double acceptedTime_ = 0; ///< end of the last accepted step [s]
};

} // namespace tokay::structure
