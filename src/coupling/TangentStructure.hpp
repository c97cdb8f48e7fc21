#pragma once

#include <Eigen/Core>

namespace tokay::coupling {

/// The structure as the block method sees it within one time step: equations
/// R(d) = Pᵀ F of N unknowns d that can be linearised and solved, and the
/// linear map P between them and the fluid's interface.
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

    /// P d: displacements of the interface, for several d at once.
    virtual Eigen::MatrixXd displacements(const Eigen::MatrixXd& d) = 0;

    /// Pᵀ F, N x m: what forces on the fluid's faces do to the structure.
    virtual Eigen::MatrixXd loads(const Eigen::MatrixXd& forces) = 0;
};

} // namespace tokay::coupling
