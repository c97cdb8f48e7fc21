// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

#include <Eigen/Core>

namespace tokay::coupling {

/// Criteria besides the fluid's tolerance, which is the relative one of the
/// displacement. Norms are root mean squares over all components.
struct ConvergenceOptions {
    double absoluteDisplacement = 0; ///< [m]
    double relativeForce = 0;
    double absoluteForce = 0; ///< [N or N/m]

    /// Whether the force has to converge too.
    bool limitsForce() const { return relativeForce > 0 || absoluteForce > 0; }

    static const SchemaOf<ConvergenceOptions>& schema() {
        static const SchemaOf<ConvergenceOptions> schema = {
            {"absoluteDisplacement", &ConvergenceOptions::absoluteDisplacement, "[0, inf)", "m",
             "A root-mean-square displacement residual below this is converged in any case."},
            {"relativeForce", &ConvergenceOptions::relativeForce, "[0, 1)", "",
             "Relative change of force between coupling iterations; not checked if both force "
             "entries are 0."},
            {"absoluteForce", &ConvergenceOptions::absoluteForce, "[0, inf)", "N (2D: N/m)",
             "A root-mean-square change of force below this is converged in any case."}};
        return schema;
    }
};

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
    ConvergenceCriteria(const ConvergenceOptions& options, double tolerance);

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
    ConvergenceOptions options_;
    Eigen::VectorXd previousForces_;
};

} // namespace tokay::coupling
