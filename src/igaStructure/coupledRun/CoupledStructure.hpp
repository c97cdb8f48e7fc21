// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/coupledRun/CouplingScheme.hpp"
#include "igaStructure/coupledRun/StructureSide.hpp"
#include "igaStructure/coupledRun/restart.hpp"
#include "igaStructure/run/RunOutput.hpp"

namespace tokay::structure {

/// Solves the structure for the fluid's forces and leads the iteration.
class CoupledStructure : public StructureSide {
  public:
    /// Goes on from the saved state that fits the fluid's start, if it has to.
    /// @param timer  is kept by reference
    CoupledStructure(const Case& structureCase, Body& body, const WetBoundary& boundary,
                     const channel::Interface& fluid, PhaseTimer& timer, const Report& report);

    Eigen::VectorXd beginTimeStep(int step, double time, double deltaT) override;
    Answer iterate(const std::vector<double>& forces, double fluidResidual) override;
    Answer acceptTimeStep(const std::vector<double>& forces, bool writeResults) override;
    void rejectTimeStep() override;

  private:
    const MotionState& begin(const std::optional<StartState>& start, const Report& report);
    void restoreScheme(coupling::StateReader& state, const Report& report);
    void save();

    const Case& case_;
    const WetBoundary& boundary_;
    PhaseTimer& timer_;
    SubsteppedIntegrator integrator_;
    std::optional<StartState> start_;
    WetStructure structure_;
    std::unique_ptr<CouplingScheme> scheme_;
    RunOutput output_;
    StepReport report_;
    const bool audits_;
    double deltaT_ = 0;
};

} // namespace tokay::structure
