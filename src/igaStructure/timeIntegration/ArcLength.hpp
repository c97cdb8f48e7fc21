// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"
#include "igaStructure/timeIntegration/NewtonOptions.hpp"
#include "igaStructure/timeIntegration/Stepper.hpp"

namespace tokay::structure {

/// Follows a static equilibrium path through limit points. Time is the load's
/// parameter and an unknown beside the displacement: it may fall again. A step
/// ends at a given distance |change of displacement| from where it began; from
/// there the path goes on in the direction in which it came.
/// Source: Crisfield 1981 (cylindrical arc length), the constraint linearised
/// in each iteration
class ArcLength : public Stepper {
  public:
    /// Starts undeformed at time 0.
    /// @param model      is kept by reference
    /// @param firstStep  of time, to which the first distance belongs [s]
    ArcLength(StructuralModel& model, const NewtonOptions& newton, double firstStep);

    /// One step; its length is halved as long as Newton's method fails, and
    /// grows again while it converges fast, up to the first one's length.
    /// @throws SolverError if it fails with a length of 1/1024 of the first one
    void advance();
    StepEffort advance(double /*time*/, double /*deltaT*/) override {
        advance();
        return {nIterations_, residual_};
    }

    /// End of the path so far; velocity and acceleration are zero.
    const MotionState& state() const override { return state_; }
    Energies energies() const override {
        return {0, model_.strainEnergy(state_.displacement), externalWork_, 0};
    }

  private:
    struct Iterate {
        Eigen::VectorXd displacement;
        double time;
    };
    Eigen::VectorXd force(const Iterate& at) const;
    /// Derivative of the forces by time.
    Eigen::VectorXd loadRate(const Iterate& at) const;
    void factorise(const Iterate& at);
    Iterate predict();
    bool correct(Iterate& iterate);
    void accept(const Iterate& iterate);

    StructuralModel& model_;
    NewtonOptions newton_;
    double firstStep_;
    double firstLength_ = 0;
    double length_ = 0;
    std::unique_ptr<LinearSolver> solver_; ///< LU: tangents are indefinite beyond a limit
    MotionState state_;
    Eigen::VectorXd direction_; ///< of the last step
    Eigen::VectorXd totalForce_;
    double externalWork_ = 0;
    int nIterations_ = 0;
    double residual_ = 0;
};

} // namespace tokay::structure
