// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/timeIntegration/Stepper.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

namespace tokay::structure {

/// Implicit time steps. One in which equilibrium is not found is taken in parts,
/// halved until they succeed and growing again afterwards.
class ImplicitStepper : public Stepper {
  public:
    /// @param model    is kept by reference
    /// @param minStep  shortest part of a step [s]
    ImplicitStepper(StructuralModel& model, const TimeScheme& scheme, const NewtonOptions& newton,
                    double minStep)
        : model_(model), isStatic_(!scheme.dynamic), newton_(newton),
          integrator_(model, scheme, newton, 0), minStep_(minStep) {}

    /// @throws SolverError if the shortest part fails; in a static analysis names the limit
    ///         point, if it is that

    StepEffort advance(double time, double deltaT) override;
    const MotionState& state() const override { return integrator_.state(); }
    Energies energies() const override { return integrator_.energies(); }

  private:
    [[noreturn]] void throwFailed(double time, const SolverError& error);

    StructuralModel& model_;
    bool isStatic_;
    NewtonOptions newton_;
    TimeIntegrator integrator_;
    double minStep_;
};

} // namespace tokay::structure
