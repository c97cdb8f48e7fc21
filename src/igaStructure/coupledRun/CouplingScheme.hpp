// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/FixedPointDriver.hpp"
#include "coupling/StateReader.hpp"
#include "coupling/StateWriter.hpp"
#include "igaStructure/coupledRun/WetStructure.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// How fluid and structure come to agree within each time step: beginTimeStep,
/// iterate as often as it takes, then acceptTimeStep or rejectTimeStep. The
/// structure has begun the step before; it answers the final forces before the
/// step is accepted.
class CouplingScheme {
  public:
    virtual ~CouplingScheme() = default;

    /// @return  predicted displacements of the fluid's points [m]
    virtual Eigen::VectorXd beginTimeStep(double deltaT) = 0;

    /// @param forces         on the fluid's faces, at the last displacements returned
    /// @param fluidResidual  initial residual of its momentum equation
    virtual coupling::Iteration iterate(const std::vector<double>& forces,
                                        double fluidResidual) = 0;

    /// Solves the structure for the step's final forces.
    /// @return  displacements of the fluid's points [m]
    virtual Eigen::VectorXd finalAnswer(const std::vector<double>& forces) = 0;

    /// @param xTilde  the structure's answer to the final forces
    /// @return        residual of these
    virtual double acceptTimeStep(const Eigen::VectorXd& xTilde) = 0;

    virtual void rejectTimeStep() = 0;

    /// Displacements that the last forces belong to.
    virtual const Eigen::VectorXd& x() const = 0;

    /// A scheme can go on from what one of the same name has saved.
    virtual std::string name() const = 0;
    virtual void save(coupling::StateWriter& state) const = 0;
    virtual void restore(coupling::StateReader& state) = 0;

    virtual const coupling::StepStatistics& statistics() const = 0;
};

/// The scheme that the options name.
/// @param tolerance  of the fluid; @see coupling::ConvergenceCriteria
/// @param structure  is kept by reference
/// @param initial    displacement of its unknowns
/// @param timer      is kept by reference
/// @throws InputError if an option or the tolerance is out of its range
std::unique_ptr<CouplingScheme> makeCouplingScheme(const coupling::CouplingOptions& options,
                                                   double tolerance, WetStructure& structure,
                                                   const Eigen::VectorXd& initial,
                                                   PhaseTimer& timer);

} // namespace tokay::structure
