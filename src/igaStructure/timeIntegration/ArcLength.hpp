// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"
#include "igaStructure/timeIntegration/NewtonOptions.hpp"
#include "igaStructure/timeIntegration/RoundingFloor.hpp"
#include "igaStructure/timeIntegration/Stepper.hpp"
#include "igaStructure/timeIntegration/TimeOptions.hpp"

#include <optional>
#include <string>

namespace tokay::structure {

/// Follows a static equilibrium path through limit points, where a structure snaps and no
/// load step converges. Time is the parameter of loads and of supports that move and an unknown
/// beside the displacement: it may fall again. A step ends on the arc, at a given distance |change
/// of displacement| from where it began; from there the path goes on in the direction in which it
/// came. An iteration that fails, leaves the range of the loads or turns back is repeated with half
/// the arc; arcs grow and shrink with the square root of the wanted number of iterations over that
/// of the last step. The step that would pass the end is solved at the end instead. Source:
/// Crisfield 1981 (cylindrical arc length), the constraint linearised in each iteration; Ramm 1981
/// (rule for the arc)
class ArcLength : public Stepper {
  public:
    /// Starts undeformed at time 0.
    /// @param model      is kept by reference
    /// @param firstStep  of time, to which the first arc belongs [s]
    /// @param end        time that is met exactly [s]
    ArcLength(StructuralModel& model, const NewtonOptions& newton, const EquilibriumPath& path,
              double firstStep, double end);

    /// Goes on from a state in equilibrium, towards larger times.
    void restart(const MotionState& state);

    /// Takes one step.
    /// @throws SolverError if it fails with an arc of 1e-4 of the first one
    StepEffort advance();
    StepEffort advance(double /*time*/, double /*deltaT*/) override { return advance(); }

    /// End of the path so far; velocity and acceleration are zero.
    const MotionState& state() const override { return state_; }
    Energies energies() const override {
        const double ofSupports = model_.supportShift(state_.time).energyAt(state_.displacement);
        return {0, model_.strainEnergy(state_.displacement) + ofSupports, externalWork_, 0};
    }

  private:
    struct Iterate {
        Eigen::VectorXd displacement;
        double time;
    };
    Eigen::VectorXd force(const Iterate& at) const;
    StructuralModel::Internal internalForce(const Iterate& at) const;
    Eigen::VectorXd forceAndReaction(const Iterate& at);
    /// Rates of change in time, at a displacement.
    struct Rates {
        Eigen::VectorXd force;    ///< of the loads [N/s]
        Eigen::VectorXd supports; ///< of prescribed displacements [m/s]
    };
    Rates ratesInTime(const Iterate& at) const;
    Eigen::VectorXd rate(const Iterate& at) const;
    void factorise(const Iterate& at, const Eigen::VectorXd* linearisedAt);
    Iterate predict();
    bool passesEnd(const Iterate& iterate) const;
    template <class Attempt>
    std::optional<Iterate> guarded(const Attempt& attempt);
    std::optional<Iterate> attempt();
    std::optional<Iterate> attemptArc(const Iterate& predicted);
    std::optional<Iterate> attemptEnd(const Iterate& beyond);
    bool converge(Iterate& iterate, std::optional<double> arc);
    bool isInRange(const Iterate& iterate) const;
    bool goesOn(const Iterate& iterate, const Iterate& predicted) const;
    void accept(const Iterate& iterate);
    [[noreturn]] void throwLost() const;

    StructuralModel& model_;
    NewtonOptions newton_;
    EquilibriumPath path_;
    double firstStep_;
    double end_;
    double firstArc_ = 0;
    double arc_ = 0;
    double lastArc_ = 0;
    SparseMatrix tangent_;
    std::unique_ptr<LinearSolver> solver_; ///< LU: tangents are indefinite beyond a limit
    RoundingFloor rounding_;
    MotionState state_;
    Eigen::VectorXd direction_;  ///< of the last step
    Eigen::VectorXd totalForce_; ///< reactions included
    double externalWork_ = 0;
    double farthestTime_; ///< largest |time| so far, the end included
    int nIterations_ = 0; ///< of the last attempt
    int nSolutions_ = 0;  ///< of all attempts of a step, predictions included
    double residual_ = 0;
    std::string failure_; ///< why the last attempt failed
};

} // namespace tokay::structure
