// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::coupling {

/// The structure's equations within one time step, for a method that uses their
/// tangent: R(d) = L for N unknowns d, L being what the fluid's forces do to
/// them, and the motion x(d) of the fluid's interface.
class LinearisedStructure {
  public:
    virtual ~LinearisedStructure() = default;

    /// Unknowns d of the accepted state.
    virtual Eigen::VectorXd acceptedUnknowns() const = 0;

    /// R(d): inertia, stiffness and all loads but the fluid's.
    virtual Eigen::VectorXd residual(const Eigen::VectorXd& d) = 0;

    /// Assembles and factors K = dR/dd.
    /// @throws SolverError if K is singular
    virtual void linearise(const Eigen::VectorXd& d) = 0;

    /// How much of an imbalance a step with the K and P of an earlier linearise() may leave for
    /// them to serve once more; 0: there are none for this time step, or none is to serve again.
    virtual double reuseContraction() const { return 0; }

    /// K⁻¹ b for several b at once, N x m, with the K of the last linearise().
    virtual Eigen::MatrixXd responses(const Eigen::MatrixXd& b) = 0;

    /// x(d): displacements of the interface.
    virtual Eigen::VectorXd displacements(const Eigen::VectorXd& d) = 0;

    /// P D, for several D at once, with P = dx/dd where last linearised.
    virtual Eigen::MatrixXd variations(const Eigen::MatrixXd& D) = 0;

    /// L: what forces on the fluid's faces do to the structure at d.
    virtual Eigen::VectorXd loads(const Eigen::VectorXd& faceForces, const Eigen::VectorXd& d) = 0;

    /// The d of R(d) = L, which the structure accepts if the step ends with it.
    /// @param start  for Newton's method
    /// @throws SolverError if that fails
    virtual Eigen::VectorXd solveFor(const Eigen::VectorXd& loads,
                                     const Eigen::VectorXd& start) = 0;
};

/// The structure as a coupling method sees it within one time step, x̃ = S(F).
class CoupledStructure {
  public:
    virtual ~CoupledStructure() = default;

    /// Displacements of the fluid's points in the accepted state [m].
    virtual Eigen::VectorXd acceptedDisplacements() const = 0;

    /// Displacements x̃ of the fluid's points under forces on its faces.
    /// @throws SolverError if the structure has no solution
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& faceForces) = 0;

    /// Its equations, if they can be linearised; else none.
    virtual LinearisedStructure* linearised() { return nullptr; }
};

} // namespace tokay::coupling
