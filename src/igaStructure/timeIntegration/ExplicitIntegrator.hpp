// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"
#include "igaStructure/timeIntegration/Stepper.hpp"

namespace tokay::structure {

/// Advances a structure by central differences with the lumped mass: no
/// equilibrium iterations, but stable only for steps below 2 / (highest angular
/// frequency). That limit is estimated from the tangent, and a step is taken in
/// as many equal parts as it needs.
///
/// Supports that move have the velocity and acceleration of their motion, by differences
/// over a part.
///
/// Mass damping is taken at the middle of a part; stiffness damping, which would
/// lower the limit further, is refused.
class ExplicitIntegrator : public Stepper {
  public:
    /// Fraction of the stable step that is used: the tangent stiffens on the way.
    static constexpr double safety = 0.9;

    /// Starts at rest, undeformed.
    /// @param model  is kept by reference
    /// @throws InputError if the model has stiffness damping, or supports are displaced at
    ///         the start
    ExplicitIntegrator(StructuralModel& model, double startTime);

    /// @throws SolverError if the motion grows beyond all bounds
    StepEffort advance(double time, double deltaT) override;

    /// Displacement and velocity belong to the same time.
    const MotionState& state() const override { return state_; }
    Energies energies() const override { return energies_; }

    /// Largest stable step at a state [s].
    double stableStep(const Eigen::VectorXd& displacement);

  private:
    Eigen::VectorXd external(double time) const;
    Eigen::VectorXd imbalance(const Eigen::VectorXd& velocity) const;
    void startSupports(double deltaT);
    void setAcceleration(const Eigen::VectorXd& velocity, const Eigen::VectorXd& ofSupports);
    int nPartsUntil(double time);
    void advancePart(double time, double deltaT);

    StructuralModel& model_;
    SparseMatrix mass_;
    std::unique_ptr<LinearSolver> solver_;
    MotionState state_;
    bool isAtStart_ = true;      ///< supports have no rates yet
    Eigen::VectorXd totalForce_; ///< followers included
    StructuralModel::SupportShift shift_;
    Eigen::VectorXd vibration_; ///< of the highest frequency, from the last estimate
    Energies energies_;
};

} // namespace tokay::structure
