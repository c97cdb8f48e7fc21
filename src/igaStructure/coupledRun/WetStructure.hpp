// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/TangentStructure.hpp"
#include "igaStructure/coupledRun/WetBoundary.hpp"
#include "igaStructure/run/PhaseTimer.hpp"
#include "igaStructure/timeIntegration/SubsteppedIntegrator.hpp"

namespace tokay::structure {

/// A structure and the fluid's interface around it within a time step: what
/// motion of the interface answers forces on it, and, as TangentStructure and
/// without substeps, the equations behind that.
class WetStructure : public coupling::TangentStructure {
  public:
    /// Borrows all.
    WetStructure(const StructuralModel& model, SubsteppedIntegrator& integrator,
                 const WetBoundary& boundary, PhaseTimer& timer)
        : model_(model), integrator_(integrator), boundary_(boundary), timer_(timer) {}

    void beginTimeStep(double time, double deltaT);

    /// Solves the structure.
    /// @param forces  on the fluid's faces
    /// @return        displacements of the fluid's points [m]
    Eigen::VectorXd answer(const std::vector<double>& forces);

    /// The same for forces on the unknowns.
    Eigen::VectorXd answerTo(const Eigen::VectorXd& loads);

    /// Latest iterate of the structure's unknowns.
    const Eigen::VectorXd& displacement() const { return integrator_.displacement(); }

    /// Displacement of its unknowns at which the last forces were mapped.
    const Eigen::VectorXd& mappedAt() const { return mappedAt_; }

    /// Of Newton's method, in this time step.
    int nIterations() const { return nIterations_; }

    Eigen::VectorXd residual(const Eigen::VectorXd& d) override;
    void factor(const Eigen::VectorXd& d) override;
    Eigen::MatrixXd solve(const Eigen::MatrixXd& b) override {
        return integrator_.singleStep().responses(b);
    }
    Eigen::VectorXd displacements(const Eigen::VectorXd& d) override;
    Eigen::MatrixXd variations(const Eigen::MatrixXd& D) override;
    Eigen::VectorXd loads(const Eigen::VectorXd& forces, const Eigen::VectorXd& d) override;

  private:
    const StructuralModel& model_;
    SubsteppedIntegrator& integrator_;
    const WetBoundary& boundary_;
    PhaseTimer& timer_;
    Eigen::VectorXd mappedAt_;
    Eigen::VectorXd factoredAt_; ///< empty: nowhere in this time step
    int nIterations_ = 0;
};

} // namespace tokay::structure
