// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/coupledRun/FluidLink.hpp"
#include "igaStructure/coupledRun/restart/StateFolder.hpp"
#include "igaStructure/edgeCoupling/MovedStructure.hpp"
#include "igaStructure/run/PhaseTimer.hpp"
#include "igaStructure/run/RunOutput.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// The session with the loaded structure, as the moved one leads it: in each time step it
/// answers displacements with forces until the loaded one, which holds the coupling method,
/// says that the two agree; as a fluid does in its outer correctors.
class EdgeSession {
  public:
    /// Borrows all.
    /// @param structureCase  of the moved structure
    /// @param moved  restored from the state that the run starts from
    /// @param start  that state; none: at rest
    EdgeSession(const Case& structureCase, const Body& body, MovedStructure& moved,
                const std::optional<SavedState>& start, const mapper::EdgeQuadrature& edge,
                FluidLink& link, Report report);

    /// All time steps of the case after the start. Where results are written both structures
    /// save their states, from which a run can go on.
    /// @throws SolverError if a step has not converged after coupling.maxIterations: the
    ///         residual of each
    void run();

  private:
    channel::Interface interface() const;
    int nStepsBefore() const;
    void save(const std::vector<double>& displacements, double deltaT);
    void advance(int step, double time, double deltaT, bool writes);
    channel::Displacements exchange(const channel::Message& message);
    [[noreturn]] void throwNotConverged(double time) const;
    void reportIterations() const;

    const Case& case_;
    MovedStructure& moved_;
    const mapper::EdgeQuadrature& edge_;
    StateFolder states_;
    double startTime_;                       ///< [s]
    std::vector<double> startDisplacements_; ///< of the edge's points [m]
    FluidLink& link_;
    Report report_;
    RunOutput output_;
    PhaseTimer timer_;
    std::vector<double> residuals_; ///< of this time step
    std::vector<int> iterations_;   ///< of each time step
};

} // namespace tokay::structure
