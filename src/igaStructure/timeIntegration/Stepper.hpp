// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/timeIntegration/MotionState.hpp"

#include <string>

namespace tokay::structure {

/// Effort of a step.
struct StepEffort {
    int nIterations = 0; ///< of Newton's method; explicit: equal parts
    double residual = 0; ///< relative, of the last iterate
    std::string note;    ///< for the log: how the step was taken, if the stepper chose that
};

/// Advances a structure that runs alone, one time step after the other.
class Stepper {
  public:
    virtual ~Stepper() = default;

    /// Takes the next step. A stepper along an equilibrium path chooses its own times.
    /// @param time    at the end of the step [s]
    /// @param deltaT  of the step; steps of equal length give exactly the same [s]
    /// @throws SolverError if it fails
    virtual StepEffort advance(double time, double deltaT) = 0;

    /// Motion at the end of the last step.
    virtual const MotionState& state() const = 0;
    virtual Energies energies() const = 0;
};

} // namespace tokay::structure
