// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CoupledStructure.hpp"

namespace tokay::coupling {

/// A fluid and a structure small enough to be solved both ways: coupled from
/// outside, by calls of fluid and structure, and at once. The unknowns of the
/// structure are the displacements of the interface, and forces act on them.
class CoupledModel : public CoupledStructure, public LinearisedStructure {
  public:
    virtual int nUnknowns() const = 0;

    /// Of the step begun last.
    virtual double deltaT() const = 0;

    virtual void beginTimeStep() = 0;

    /// Forces of the fluid when the interface is displaced by x.
    /// @throws SolverError if the fluid has no solution
    virtual Eigen::VectorXd fluid(const Eigen::VectorXd& x) = 0;

    /// Displacement of the structure under these forces.
    /// @param start  for Newton's method
    virtual Eigen::VectorXd structure(const Eigen::VectorXd& forces, const Eigen::VectorXd& start);

    /// Solution of the coupled step.
    virtual Eigen::VectorXd monolithic(const Eigen::VectorXd& start) = 0;

    /// Ends the step with the fluid as it was solved last, and this displacement.
    virtual void acceptTimeStep(const Eigen::VectorXd& x) = 0;

    /// Where Newton's method starts in solve() and solveFor().
    void startFrom(const Eigen::VectorXd& x) { start_ = x; }

    /// At rest: methods are made before the first step.
    Eigen::VectorXd acceptedUnknowns() const override { return Eigen::VectorXd::Zero(nUnknowns()); }
    Eigen::VectorXd acceptedDisplacements() const override { return acceptedUnknowns(); }
    Eigen::VectorXd solve(const Eigen::VectorXd& forces) override {
        return structure(forces, start_);
    }
    Eigen::VectorXd solveFor(const Eigen::VectorXd& loads, const Eigen::VectorXd&) override {
        return structure(loads, start_);
    }
    LinearisedStructure* linearised() override { return this; }
    Eigen::VectorXd displacements(const Eigen::VectorXd& d) override { return d; }
    Eigen::MatrixXd variations(const Eigen::MatrixXd& D) override { return D; }
    Eigen::VectorXd loads(const Eigen::VectorXd& forces, const Eigen::VectorXd&) override {
        return forces;
    }

  private:
    Eigen::VectorXd start_;
};

} // namespace tokay::coupling
