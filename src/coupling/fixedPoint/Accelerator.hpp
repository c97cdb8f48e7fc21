// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/StepHistory.hpp"

#include <Eigen/Core>

namespace tokay::coupling {

/// Finds the next displacement in the search for x = x̃, where x̃ is the structural
/// solution for the fluid's forces at x. Each has a type
/// Options with its schema, from which it is constructed.
class Accelerator : public StepHistory {
  public:
    /// @param x              displacement that the forces belong to
    /// @param xTilde         displacement that these forces cause
    /// @param fluidResidual  relative error that the fluid's forces may have
    /// @return               x of the next coupling iteration
    virtual Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                                 double fluidResidual) = 0;

    /// Whether x is to converge within a step.
    virtual bool iterates() const { return true; }

    /// Pairs of differences in use, for statistics.
    virtual int nColumns() const { return 0; }
};

} // namespace tokay::coupling
