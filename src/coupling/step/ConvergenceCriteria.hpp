// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

#include <Eigen/Core>

#include <optional>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// Criterion on the force where the user gives no limits.
enum class ForceCriterion { automatic, none };

/// Criteria besides the fluid's tolerance, which is the relative one of the
/// displacement. Norms are root mean squares over all components.
struct ConvergenceOptions {
    double absoluteDisplacement = 0; ///< [m]
    ForceCriterion force = ForceCriterion::automatic;
    double relativeForce = 0;
    double absoluteForce = 0; ///< [N or N/m]

    /// Whether there are limits that the user has given.
    bool hasForceLimits() const { return relativeForce > 0 || absoluteForce > 0; }

    /// Whether the force has to converge too.
    bool limitsForce() const { return hasForceLimits() || force == ForceCriterion::automatic; }

    static const SchemaOf<ConvergenceOptions>& schema();
};

/// Whether fluid and structure agree: each criterion i is a norm over its
/// allowed value, ratio_i = norm_i / max(relative_i |scale_i|, absolute_i), and
/// all are folded into one residual = tolerance x largest ratio, so that all
/// hold if and only if it is below the tolerance.
///
/// Displacement: norm of xTilde - x against x and xTilde, the tolerance being
/// the relative limit. That alone is blind where a structure is heavy: within a
/// time step its inertia, not the force, decides where it is, and a wrong force
/// only shows many steps later.
///
/// Force: norm of the change since the last coupling iteration, against the
/// force or its mean over the run's time steps, whichever is larger: a force
/// that passes through zero, or fades, need not converge to all its digits.
/// In the first coupling iteration of a step the change is unknown and the
/// criterion not met. The automatic criterion's limit is 1e-3, but at least one
/// and at most ten tolerances. It is met as well where the fluid's own momentum
/// residual is below the tolerance and 1e-4: what then still changes is noise.
class ConvergenceCriteria {
  public:
    /// @throws InputError unless 0 < tolerance <= 1; 1: nothing has to converge
    ConvergenceCriteria(const ConvergenceOptions& options, double tolerance);

    void beginTimeStep() {
        previousForces_.resize(0);
        flowHasConverged_ = false;
    }

    /// @param forces         of this coupling iteration, finite
    /// @param fluidResidual  of the momentum equation; none: there is none
    /// @throws SolverError if the structural solution is not finite
    double residual(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                    const Eigen::VectorXd& forces,
                    std::optional<double> fluidResidual = std::nullopt);

    /// The same of forces that are to end the step. A flow that had converged in the last
    /// coupling iteration has done so: since then it has stayed at the same displacement.
    /// If they do not end it, the next iteration is compared with the last one as well.
    double finalResidual(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                         const Eigen::VectorXd& forces) const;

    /// @param forces  of the accepted step
    void acceptTimeStep(const Eigen::VectorXd& forces);

    double tolerance() const { return tolerance_; }

    void save(StateWriter& state) const;
    /// @throws channel::PeerError if the state is damaged
    void restore(StateReader& state);

  private:
    double displacementResidual(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde) const;
    double forceRatio(const Eigen::VectorXd& forces) const;
    double allowedForceChange(const Eigen::VectorXd& forces) const;

    double tolerance_;
    ConvergenceOptions options_;
    bool flowHasConverged_ = false; ///< in the last coupling iteration
    Eigen::VectorXd previousForces_;
    double meanForce_ = 0; ///< over the accepted time steps of the run
    int nTimeSteps_ = 0;
};

} // namespace tokay::coupling
