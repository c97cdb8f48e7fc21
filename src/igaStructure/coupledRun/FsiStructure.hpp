// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CoupledStructure.hpp"
#include "igaStructure/coupledRun/WetBoundary.hpp"
#include "igaStructure/run/PhaseTimer.hpp"
#include "igaStructure/timeIntegration/SubsteppedIntegrator.hpp"

namespace tokay::structure {

/// A structure and the fluid's interface around it, as a coupling method sees
/// them: the motion of the interface under forces on its faces, and, without
/// substeps, the equations behind that.
class FsiStructure : public coupling::CoupledStructure, public coupling::LinearisedStructure {
  public:
    /// Borrows all.
    FsiStructure(const StructuralModel& model, SubsteppedIntegrator& integrator,
                 const WetBoundary& boundary, PhaseTimer& timer)
        : model_(model), integrator_(integrator), boundary_(boundary), timer_(timer) {}

    void beginTimeStep(double time, double deltaT);

    Eigen::VectorXd acceptedDisplacements() const override;
    Eigen::VectorXd solve(const Eigen::VectorXd& faceForces) override;
    coupling::LinearisedStructure* linearised() override { return this; }

    Eigen::VectorXd acceptedUnknowns() const override { return integrator_.state().displacement; }
    Eigen::VectorXd residual(const Eigen::VectorXd& d) override;
    void linearise(const Eigen::VectorXd& d) override;
    Eigen::MatrixXd responses(const Eigen::MatrixXd& b) override;
    Eigen::VectorXd displacements(const Eigen::VectorXd& d) override;
    Eigen::MatrixXd variations(const Eigen::MatrixXd& D) override;
    Eigen::VectorXd loads(const Eigen::VectorXd& faceForces, const Eigen::VectorXd& d) override;
    double reuseContraction() const override;
    Eigen::VectorXd solveFor(const Eigen::VectorXd& loads, const Eigen::VectorXd& start) override;

    /// Displacement of the unknowns at which the last forces were mapped.
    const Eigen::VectorXd& mappedAt() const { return mappedAt_; }

    /// Newton iterations in this time step.
    int nIterations() const { return nIterations_; }

  private:
    Eigen::VectorXd solveUnder(const Eigen::VectorXd& loads);
    Eigen::VectorXd map(const Eigen::VectorXd& faceForces, const Eigen::VectorXd& d);

    const StructuralModel& model_;
    SubsteppedIntegrator& integrator_;
    const WetBoundary& boundary_;
    PhaseTimer& timer_;
    Eigen::VectorXd mappedAt_;
    Eigen::VectorXd linearisedAt_; ///< of P
    // A coupling method asks for these again where the last Newton iteration has ended. The
    // first of a pair is the displacement that the second belongs to; empty: none.
    Eigen::VectorXd residualAt_;
    Eigen::VectorXd residual_;
    Eigen::VectorXd displacementsAt_;
    Eigen::VectorXd displacements_;
    bool isLinearised_ = false; ///< in this time step; K is that of linearisedAt_ then
    int nIterations_ = 0;
};

} // namespace tokay::structure
