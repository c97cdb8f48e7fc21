// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::coupling {

/// The structure as the block method sees it within one time step: equations
/// R(d) = L of N unknowns d, L being what the fluid's forces do to them, that
/// can be linearised and solved; and the motion x(d) of the fluid's interface.
class TangentStructure {
  public:
    virtual ~TangentStructure() = default;

    /// R(d): inertia, stiffness and all loads but the fluid's.
    virtual Eigen::VectorXd residual(const Eigen::VectorXd& d) = 0;

    /// Assembles and factors K = dR/dd.
    /// @throws SolverError if K is singular
    virtual void factor(const Eigen::VectorXd& d) = 0;

    /// K⁻¹ b for several b at once, N x m, with the K factored last.
    virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& b) = 0;

    /// x(d): displacements of the interface.
    virtual Eigen::VectorXd displacements(const Eigen::VectorXd& d) = 0;

    /// P D, for several D at once, with P = dx/dd where K was factored last.
    virtual Eigen::MatrixXd variations(const Eigen::MatrixXd& D) = 0;

    /// L: what forces on the fluid's faces do to the structure at d.
    virtual Eigen::VectorXd loads(const Eigen::VectorXd& forces, const Eigen::VectorXd& d) = 0;
};

} // namespace tokay::coupling
