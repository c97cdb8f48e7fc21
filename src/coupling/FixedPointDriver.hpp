// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/Accelerator.hpp"
#include "coupling/ConvergenceCriteria.hpp"
#include "coupling/CouplingOptions.hpp"
#include "coupling/Predictor.hpp"

#include <Eigen/Core>

#include <memory>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// Answer to one exchange.
struct Iteration {
    Eigen::VectorXd x;      ///< displacement for the next exchange
    double residual = 1;    ///< all criteria hold if below the tolerance
    bool converged = false; ///< they do
};

struct StepStatistics {
    int nExchanges = 0;       ///< without the final one, which only accepts
    double firstResidual = 1; ///< how good the prediction was
    double lastResidual = 1;
    bool converged = false;
    int nColumns = 0; ///< of the quasi-Newton model
};

/// Leads the search for the interface displacement x = S(F(x)) through each
/// time step: predicts it, judges the structure's answer xTilde, accelerates.
/// x holds all components of all interface points [m].
///
/// beginTimeStep, iterate (any number of times), then acceptTimeStep or
/// rejectTimeStep. Explicit coupling: the first iterate returns x unchanged
/// and converged, with the residual 0, because it is not controlled.
class FixedPointDriver {
  public:
    /// @param tolerance  of the fluid, relative; @see ConvergenceCriteria
    /// @param initial    displacement at the start
    /// @throws InputError if an option or the tolerance is out of its range
    FixedPointDriver(const CouplingOptions& options, double tolerance,
                     const Eigen::VectorXd& initial);

    /// @return  predicted x, which the first forces will belong to
    const Eigen::VectorXd& beginTimeStep(double deltaT);

    /// @param xTilde         structure's answer to the forces at the last x
    /// @param fluidResidual  initial residual of the fluid's momentum equation
    /// @param forces         of this exchange, for criteria on the force
    /// @throws SolverError if a value is not finite
    Iteration iterate(const Eigen::VectorXd& xTilde, double fluidResidual,
                      const Eigen::VectorXd& forces = {});

    /// Ends the step with the structure's answer to the final forces. For these
    /// the fluid stays where it was in the last exchange: the x returned by the
    /// last iterate is not used.
    /// @return  residual of the final forces
    /// @throws  SolverError if a value is not finite
    double acceptTimeStep(const Eigen::VectorXd& xTilde);

    /// Forgets the step, which will be tried again.
    void rejectTimeStep();

    /// All that earlier steps have left behind, between two time steps.
    void save(StateWriter& state) const;

    /// Goes on from what save() wrote. The accelerator begins anew if it was
    /// another one.
    /// @throws channel::PeerError if the state is damaged
    void restore(StateReader& state);

    /// Displacement that the fluid has been given last.
    const Eigen::VectorXd& x() const { return x_; }

    /// Of the current step, or of the last one until the next begins.
    const StepStatistics& statistics() const { return statistics_; }

  private:
    Acceleration acceleration_;
    ConvergenceCriteria criteria_;
    Predictor predictor_;
    std::unique_ptr<Accelerator> accelerator_; ///< none: explicit coupling
    Eigen::VectorXd x_;                        ///< of the last exchange
    Eigen::VectorXd next_;                     ///< of the exchange to come
    double deltaT_ = 0;
    StepStatistics statistics_;
};

} // namespace tokay::coupling
