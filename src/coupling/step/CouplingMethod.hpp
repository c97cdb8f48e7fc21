// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <string>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// Result of one coupling iteration.
struct CouplingIteration {
    Eigen::VectorXd x;      ///< displacements of the fluid's points [m]
    double residual = 1;    ///< all criteria hold if below the tolerance
    bool converged = false; ///< they do
};

struct StepStatistics {
    int nIterations = 0;      ///< coupling iterations, without the final forces
    double firstResidual = 1; ///< how good the prediction was
    double lastResidual = 1;
    bool converged = false;
    int nColumns = 0; ///< of the quasi-Newton model

    void add(double residual, double tolerance, int columns) {
        firstResidual = nIterations == 0 ? residual : firstResidual;
        ++nIterations;
        lastResidual = residual;
        converged = residual < tolerance;
        nColumns = columns;
    }
};

/// How fluid and structure come to agree on the displacement x of the interface
/// within each time step: x = S(F(x)), with the forces F of the fluid and the
/// structural solution S. Without iteration the added mass of an incompressible
/// fluid makes a light structure diverge, whatever the time step.
///
/// A time step is predict(), iterate() until it has converged, then accept() or
/// reject(). The structure has begun its own step before predict(), and accepts
/// it after accept(). Between two time steps save() writes the history, and
/// restore() continues from it. x has all components of all points [m].
class CouplingMethod {
  public:
    virtual ~CouplingMethod() = default;

    /// @return  predicted x, which the first forces will belong to
    virtual const Eigen::VectorXd& predict(double deltaT) = 0;

    /// @param faceForces     on the fluid's faces, at the last x returned
    /// @param fluidResidual  initial residual of its momentum equation, if it solves one;
    ///                       0: the forces are exact
    /// @return               x for the next forces
    /// @throws SolverError if the structure has no solution
    virtual CouplingIteration iterate(const Eigen::VectorXd& faceForces,
                                      std::optional<double> fluidResidual) = 0;

    /// Ends the step with the structural solution for the final forces. For these
    /// the fluid has stayed where it was in the last coupling iteration: the x
    /// returned by that is not used.
    /// @param limit  of the residual: from there on the step does not end, and
    ///               iterate() with these forces continues it
    /// @return  x of the structure, the residual of the final forces, and whether the
    ///          step has ended
    /// @throws  SolverError if the structure has no solution; the step may be
    ///          rejected then
    virtual CouplingIteration accept(const Eigen::VectorXd& finalForces,
                                     double limit = std::numeric_limits<double>::infinity()) = 0;

    /// Takes the step back; it will be tried again, shorter.
    virtual void reject() = 0;

    /// Between two time steps: what follows depends on what save() writes alone.
    virtual void dropTangent() {}

    /// A method can continue from what one of the same name has saved.
    virtual std::string name() const = 0;
    virtual void save(StateWriter& state) const = 0;
    /// @throws channel::PeerError if the state is damaged
    virtual void restore(StateReader& state) = 0;

    /// Displacement that the last forces belong to.
    virtual const Eigen::VectorXd& x() const = 0;

    /// Statistics of the current step, or of the last one until the next begins.
    const StepStatistics& statistics() const { return statistics_; }

  protected:
    StepStatistics statistics_;
};

} // namespace tokay::coupling
