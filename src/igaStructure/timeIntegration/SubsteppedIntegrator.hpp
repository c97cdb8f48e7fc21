// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <memory>
#include <vector>

namespace tokay::structure {

/// Takes the fluid's time step in equal steps of the structure. In all of them the
/// interface force is the mean of that of the accepted state and that of the
/// iterate: an error of second order in the fluid's step. The structure's own loads
/// act at their own times.
///
/// A force that were linear in time would be as accurate, but moves the structure by
/// a sixth of the new force and a third of the old one: a fluid of large added mass
/// that asks for a displacement would have to answer each force with the opposite of
/// twice its error, the instability of the linear acceleration method.
///
/// Where the force jumps, at both ends of the step, the acceleration jumps with it.
/// Else schemes would weigh an acceleration of the old force in the first step, and
/// all but the one without dissipation be of order 1, newmark's unstable with added
/// mass.
///
/// Each solution takes all steps anew, from the accepted state.
class SubsteppedIntegrator {
  public:
    /// Starts as TimeIntegrator does.
    /// @param scheme      dynamic, if there are several steps
    /// @param nSubsteps   in a time step; 1: TimeIntegrator itself
    SubsteppedIntegrator(StructuralModel& model, const TimeScheme& scheme,
                         const NewtonOptions& newton, double startTime, int nSubsteps = 1);

    /// @param time    at the end of the fluid's step [s]
    /// @param deltaT  of the fluid's step [s]
    void beginTimeStep(double time, double deltaT);

    /// Displacement at the end of the fluid's step.
    /// @param interfaceForce  on the unknowns at that time [N]
    /// @throws SolverError if Newton's method fails in one of the steps
    const Eigen::VectorXd& solve(const Eigen::VectorXd& interfaceForce);

    /// The last solution becomes the state.
    void acceptTimeStep();

    /// Forgets the step; the state is as before beginTimeStep.
    void rejectTimeStep();

    /// Goes on from an earlier run's state, between two time steps.
    void restore(const MotionState& state, const Energies& energies);

    /// @see TimeIntegrator::dropTangent
    void dropTangent() { integrator_.dropTangent(); }

    /// Accepted state; its force is that at its time, not a mean.
    const MotionState& state() const { return isUnderWay_ ? start_ : integrator_.state(); }
    /// Displacement found by the last solve() [m].
    const Eigen::VectorXd& displacement() const { return integrator_.displacement(); }
    /// Energies of the accepted state, when no step is under way.
    const Energies& energies() const { return integrator_.energies(); }
    /// Newton iterations of the last solve, in all steps; 1 a step for a linear structure.
    int nIterations() const { return nIterations_; }

    /// The equations of a time step that is a single one of the structure.
    TimeIntegrator& singleStep();

  private:
    MotionState afterJump(MotionState state, const Eigen::VectorXd& forceChange);

    StructuralModel& model_;
    TimeIntegrator integrator_;
    const int nSubsteps_;
    SparseMatrix mass_;                        ///< none for a single step
    std::unique_ptr<LinearSolver> massSolver_; ///< none for a single step

    bool isUnderWay_ = false; ///< the integrator's state is one between
    MotionState start_;       ///< accepted
    Energies startEnergies_;
    Eigen::VectorXd startForce_; ///< of the interface [N]
    Eigen::VectorXd halfChange_; ///< half of what the last iterate's force differs by [N]
    double time_ = 0;            ///< at the end
    double deltaT_ = 0;
    /// Displacement of each step in the last solve; empty before the first
    std::vector<Eigen::VectorXd> iterates_;
    int nIterations_ = 0;
};

} // namespace tokay::structure
