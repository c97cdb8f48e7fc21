// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CouplingMethod.hpp"
#include "igaStructure/coupledRun/CoupledParticipant.hpp"
#include "igaStructure/coupledRun/FsiStructure.hpp"
#include "igaStructure/coupledRun/restart/StartState.hpp"
#include "igaStructure/run/RunOutput.hpp"

#include <memory>

namespace tokay::structure {

/// Solves the structure under the fluid's forces, by a coupling method, and writes
/// what comes of it.
class FsiParticipant : public CoupledParticipant {
  public:
    /// Continues from the saved state that fits the fluid's start, if it has to.
    /// @param timer  is kept by reference
    FsiParticipant(const Case& structureCase, Body& body, const WetBoundary& boundary,
                   const channel::Interface& fluid, PhaseTimer& timer, const Report& report);

    Eigen::VectorXd beginTimeStep(int step, double time, double deltaT) override;
    StructureResponse iterate(const Eigen::VectorXd& faceForces,
                              std::optional<double> fluidResidual) override;
    StructureResponse acceptTimeStep(const channel::Forces& final) override;
    void finishTimeStep() override;
    void rejectTimeStep() override;
    void removeStatesExcept(const std::vector<double>& fluidTimes) override {
        states_.removeExcept(fluidTimes);
    }

  private:
    void restoreMethod(const StartState& start, const Report& report);
    coupling::CouplingIteration accept(const Eigen::VectorXd& finalForces, double limit);
    void save();

    const Case& case_;
    const WetBoundary& boundary_;
    PhaseTimer& timer_;
    SubsteppedIntegrator integrator_;
    FsiStructure structure_;
    std::unique_ptr<coupling::CouplingMethod> method_;
    std::unique_ptr<RunOutput> output_;
    StateFolder states_;
    StepReport report_;
    const double tolerance_;
    const bool audits_;
    bool writesResults_ = false; ///< of the accepted step
    double deltaT_ = 0;
};

} // namespace tokay::structure
