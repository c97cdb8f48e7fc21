#pragma once

#include "coupling/FixedPointDriver.hpp"
#include "igaStructure/run/RunOutput.hpp"
#include "igaStructure/run/StructureSide.hpp"
#include "igaStructure/run/WetBoundary.hpp"

namespace tokay::structure {

/// Solves the structure for the fluid's forces and leads the iteration.
class CoupledStructure : public StructureSide {
  public:
    /// @param timer  is kept by reference
    CoupledStructure(const Case& structureCase, Body& body, const WetBoundary& boundary,
                     const coupling::Interface& fluid, PhaseTimer& timer, Report report);

    Eigen::VectorXd beginTimeStep(int step, double time, double deltaT) override;
    Answer iterate(const std::vector<double>& forces, double fluidResidual) override;
    Answer acceptTimeStep(const std::vector<double>& forces, bool writeResults) override;

  private:
    Eigen::VectorXd solve(const std::vector<double>& forces);

    const WetBoundary& boundary_;
    PhaseTimer& timer_;
    TimeIntegrator integrator_;
    coupling::FixedPointDriver driver_;
    RunOutput output_;
    StepReport report_;
};

} // namespace tokay::structure
