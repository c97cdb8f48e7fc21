// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/kinematics/ReactionColumns.hpp"
#include "igaStructure/output/ResultTable.hpp"
#include "igaStructure/run/PhaseTimer.hpp"
#include "igaStructure/run/ResultSeries.hpp"
#include "igaStructure/run/ResultsLock.hpp"
#include "igaStructure/run/StepReport.hpp"
#include "igaStructure/run/Watch.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <ctime>

namespace tokay::structure {

/// All that a run tells: the log's line and the tables' rows of each time
/// step, and the results for ParaView, locked against other runs.
class RunOutput {
  public:
    /// @param endTime  for the time to go [s]
    /// @throws InputError for a watch point that is not on the body, a field that it does not
    /// have, or another run that writes there
    RunOutput(const Case& structureCase, const Body& body, const MotionState& start, double endTime,
              Report report);

    /// Results go on with the series of an earlier run; tables begin in a
    /// folder of their own, as OpenFOAM's do.
    void continueEarlier() { results_.continueEarlier(); }

    /// Reports an accepted step and resets the timer.
    /// @param writeResults  also the .vtu and .pvd files
    /// @throws OutputError
    void finishStep(const StepReport& step, const MotionState& state, const Energies& energies,
                    PhaseTimer& timer, bool writeResults);

  private:
    void writeTables(const StepReport& step, const MotionState& state, const Energies& energies,
                     const PhaseTimer& timer, double seconds, double processorSeconds);
    std::string logLine(const StepReport& step, const MotionState& state, double seconds) const;

    ResultsLock lock_;
    Watch watch_;
    ReactionColumns reactions_;
    ResultSeries results_;
    ResultTable watchTable_;
    ResultTable reactionTable_;
    ResultTable iterationTable_;
    ResultTable energyTable_;
    double startTime_;
    double endTime_;
    Report report_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point stepStart_;
    std::clock_t processorStart_; ///< of the step
};

} // namespace tokay::structure
