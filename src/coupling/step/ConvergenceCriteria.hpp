// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CouplingOptions.hpp"

#include <Eigen/Core>

namespace tokay::coupling {

/// Whether fluid and structure agree: each criterion i is a norm over its
/// allowed value, ratio_i = norm_i / max(relative_i |scale_i|, absolute_i), and
/// all are folded into one residual = tolerance x largest ratio, so that all
/// hold if and only if it is below the tolerance.
///
/// Displacement: norm of xTilde - x against x and xTilde, the tolerance being
/// the relative limit. Force, if asked for: norm of the change since the last
/// coupling iteration, against the force; unknown, so not met, in the first of
/// a step.
class ConvergenceCriteria {
  public:
    /// @throws InputError unless 0 < tolerance <= 1; 1: nothing has to converge
    ConvergenceCriteria(const CouplingOptions& options, double tolerance);

    void beginTimeStep() { previousForces_.resize(0); }

    /// @param forces  of this coupling iteration, finite
    /// @throws SolverError if the structural solution is not finite
    double residual(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                    const Eigen::VectorXd& forces);

    /// The criterion on the displacement alone.
    /// @throws SolverError if the structural solution is not finite
    double displacementResidual(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde) const;

    double tolerance() const { return tolerance_; }

  private:
    double forceRatio(const Eigen::VectorXd& forces);

    double tolerance_;
    double absoluteDisplacement_;
    double relativeForce_;
    double absoluteForce_;
    Eigen::VectorXd previousForces_;
};

} // namespace tokay::coupling
