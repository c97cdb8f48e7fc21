// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"
#include "igaStructure/timeIntegration/MotionState.hpp"
#include "igaStructure/timeIntegration/NewtonOptions.hpp"
#include "igaStructure/timeIntegration/RoundingFloor.hpp"
#include "igaStructure/timeIntegration/TimeScheme.hpp"

#include <Eigen/Core>

#include <optional>

namespace tokay::structure {

/// Advances a structure in time. A step may be solved several times, each time
/// with another interface force, before it is accepted.
///
/// A linear structure is factored once for each new size of the time step; a
/// nonlinear one in every Newton iteration, or when the factored tangent no longer
/// serves (NewtonOptions).
class TimeIntegrator {
  public:
    /// Starts at rest, undeformed; the acceleration at the start balances the
    /// model's own loads. Supports whose motion begins with a velocity have it at the
    /// start, as after an impact that moves nothing else; its work is their kinetic energy.
    /// @param model  is kept by reference
    /// @throws SolverError if the supports of a static analysis leave rigid
    ///         motions free: names them
    /// @throws InputError if supports of a dynamic one are displaced at the start
    TimeIntegrator(StructuralModel& model, const TimeScheme& scheme, const NewtonOptions& newton,
                   double startTime);

    /// Before the first step from rest: gives supports that move their velocity and
    /// acceleration, whose formulas say them by differences over a part of the step.
    /// @param deltaT  of the step [s]
    void startSupports(double deltaT);

    /// @param time    at the end of the step [s]
    /// @param deltaT  [s]
    void beginTimeStep(double time, double deltaT);

    /// The next solve() begins its iteration at this displacement at the end of the
    /// step, in place of the accepted one. A linear structure does not look at it.
    void startFrom(const Eigen::VectorXd& displacement) {
        displacement_ = displacement;
        reaction_.resize(0);
    }

    /// Displacement at the end of the step.
    /// @param interfaceForce  on the unknowns at the end of the step, beside
    ///                        the model's own loads [N]; empty: none
    /// @throws SolverError if Newton's method fails; says where it stands
    const Eigen::VectorXd& solve(const Eigen::VectorXd& interfaceForce = {});

    /// For whoever solves the step's equations together with others: the
    /// interface force that would hold the structure at a displacement at the
    /// end of the step, 0 where it is fixed [N]. Fixed and dependent unknowns are taken
    /// as supports have them, here and in linearise().
    Eigen::VectorXd requiredForce(const Eigen::VectorXd& displacement);

    /// Factors the derivative of requiredForce() at a displacement, where the
    /// next solve() starts.
    /// @throws SolverError if it is singular
    void linearise(const Eigen::VectorXd& displacement);

    /// NewtonOptions' if there is a factored tangent for this time step that has served in the
    /// last iteration; else 0.
    double reuseContraction() const;

    /// Changes of the displacement by interface forces, a column each, by the tangent
    /// factored last.
    Eigen::MatrixXd responses(const Eigen::MatrixXd& forces);

    /// The last solution becomes the state.
    void acceptTimeStep();

    /// Forgets the step; the state is as before beginTimeStep.
    void rejectTimeStep();

    /// The next iteration takes a new tangent, so that what follows depends on the
    /// state alone: for whoever saves the state to go on from it later.
    void dropTangent() { tangentServes_ = false; }

    /// Takes back accepted time steps to take them once more: keeps what has been
    /// factored.
    void goBack(const MotionState& state, const Energies& energies);

    /// Goes on from an earlier run's state, between two time steps.
    void restore(const MotionState& state, const Energies& energies);

    /// Accepted state.
    const MotionState& state() const { return state_; }
    /// Displacement found by the last solve() [m].
    const Eigen::VectorXd& displacement() const { return displacement_; }
    const Energies& energies() const { return energies_; }
    /// Reactions of supports at the end of the step in the last solution, 0 where nothing is
    /// fixed [N].
    Eigen::VectorXd reaction() const;

    /// Newton iterations of the last solve; 1 for a linear structure.
    int nIterations() const { return nIterations_; }
    /// Out-of-balance force of each iterate of the last solve, relative.
    const std::vector<double>& residuals() const { return residuals_; }
    /// Since the start.
    int nFactorisations() const { return nFactorisations_; }
    /// [bytes]
    double bytes() const;
    const LinearSolver& solver() const { return *solver_; }

  private:
    // Balance of forces for a displacement at the end of the step.
    struct Balance {
        Eigen::VectorXd residual; ///< external - inertia - damping - internal, 0 where fixed
        Eigen::VectorXd reaction; ///< what it would be where fixed, with the other sign
        double scale = 0;         ///< largest norm of its terms
        double rounding = 0;      ///< no residual gets smaller
        double smallestVolumeRatio = 1;
    };

    void resistInertia();
    double massFactor() const;
    Eigen::VectorXd accelerationFor(const Eigen::VectorXd& displacement) const;
    Eigen::VectorXd velocityFor(const Eigen::VectorXd& acceleration) const;
    Eigen::VectorXd dampingForce(const Eigen::VectorXd& velocity) const;
    Eigen::VectorXd atAlphaF(const Eigen::VectorXd& start, const Eigen::VectorXd& end) const;
    double middleTime() const;
    Eigen::VectorXd followerForce(const Eigen::VectorXd& displacement, double time) const;
    Balance balance(const Eigen::VectorXd& displacement) const;
    void setLoads();
    StructuralModel::Internal internalForce(const Eigen::VectorXd& middle) const;
    bool isFactoredForStep() const;
    void renewTangent();
    void factorise();
    Eigen::VectorXd imbalanceAtStart() const;
    Eigen::VectorXd initialReaction() const;
    void setInitialAcceleration(const Eigen::VectorXd& ofSupports);
    void moveSupports(const Eigen::VectorXd& motion);
    void solveLinear();
    void solveNonlinear();
    void findBalance();
    Balance iterate(const Balance& current);
    std::optional<Balance> iterateWithKeptTangent(const Balance& current);
    Balance searchAlong(const Eigen::VectorXd& update, const Balance& current);
    [[noreturn]] void throwNotConverged(const char* why) const;
    std::string freeMotionsHint() const;
    void updateEnergies(const MotionState& next);

    StructuralModel& model_;
    TimeScheme scheme_;
    NewtonOptions newton_;
    SparseMatrix mass_;
    SparseMatrix stiffness_; ///< at rest: linear structures, stiffness damping
    SparseMatrix tangent_;   ///< of the internal force, then of the whole balance
    std::unique_ptr<LinearSolver> solver_;
    RoundingFloor internalRounding_;
    double inertiaRounding_; ///< rounding error of inertia, per acceleration [N s^2/m]

    MotionState state_;
    Eigen::VectorXd followerForce_;                       ///< at the state
    StructuralModel::SupportShift startShift_, endShift_; ///< at the state, and of the step
    Energies energies_;

    bool isAtStart_ = true; ///< supports have no rates yet
    double time_ = 0;
    double deltaT_ = 0;
    double resistedDeltaT_ = 0;    ///< time step whose inertia the model's springs resist
    double factoredDeltaT_ = 0;    ///< 0: the factorisation is none of a step
    bool tangentServes_ = false;   ///< the last iteration contracted enough
    Eigen::VectorXd force_;        ///< at the end of the step
    Eigen::VectorXd displacement_; ///< latest iterate at the end of the step
    /// Reactions in the balance of the latest iterate; empty: not known.
    Eigen::VectorXd reaction_;
    /// Displacement whose tangent led to the latest iterate, for mixed stresses.
    std::optional<Eigen::VectorXd> linearisedAt_;
    bool mixesStresses_ = false; ///< in this attempt

    int nIterations_ = 0;
    int nFactorisations_ = 0;
    std::vector<double> residuals_;
};

} // namespace tokay::structure
