// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/history/LowRankMatrix.hpp"
#include "coupling/step/CoupledStructure.hpp"

namespace tokay::coupling {

/// A structure in a fluid that responds linearly, L(x) = loads + J (x - xOfLoads)
/// with J = A Bᵀ of small rank:  R(d) - L(x(d)) = 0.
///
/// Newton's method needs nothing but the structure's own factors: with
/// y = K⁻¹ b and Z = K⁻¹ A the step is y + Z (1 - Bᵀ P Z)⁻¹ Bᵀ P y, that is
/// rank + 1 back-substitutions.
class BlockSystem {
  public:
    /// Borrows the structure and both vectors.
    /// @param J  from displacements of the interface to loads on the structure
    BlockSystem(LinearisedStructure& structure, const Eigen::VectorXd& loads,
                const Eigen::VectorXd& xOfLoads, LowRankMatrix J);

    /// Newton's method with line search.
    /// @param d          start
    /// @param tolerance  of the last step, relative to d
    /// @throws SolverError if it does not converge
    Eigen::VectorXd solve(Eigen::VectorXd d, double tolerance) const;

  private:
    Eigen::VectorXd imbalance(const Eigen::VectorXd& d) const;
    Eigen::VectorXd newtonStep(const Eigen::VectorXd& imbalance) const;

    LinearisedStructure& structure_;
    const Eigen::VectorXd& loads_;
    const Eigen::VectorXd& xOfLoads_;
    LowRankMatrix J_;
};

} // namespace tokay::coupling
