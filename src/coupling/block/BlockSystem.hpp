// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/block/WoodburySolver.hpp"
#include "coupling/history/LowRankMatrix.hpp"
#include "coupling/step/CoupledStructure.hpp"

namespace tokay::coupling {

/// A structure in a fluid that responds linearly, L(x) = loads + J (x - xOfLoads)
/// with J = A Bᵀ of small rank:  R(d) - L(x(d)) = 0.
///
/// Newton's method needs nothing but the structure's own factors. @see WoodburySolver
class BlockSystem {
  public:
    /// Borrows all.
    /// @param steps  of this structure, kept from one system to the next
    /// @param J      from displacements of the interface to loads on the structure
    BlockSystem(LinearisedStructure& structure, WoodburySolver& steps, const Eigen::VectorXd& loads,
                const Eigen::VectorXd& xOfLoads, const LowRankMatrix& J)
        : structure_(structure), steps_(steps), loads_(loads), xOfLoads_(xOfLoads), J_(J) {}

    /// Newton's method with line search, which keeps a tangent as long as it serves.
    /// @param d          start
    /// @param tolerance  of the error, relative to d: by the last step, or by what that has left
    ///                   of the imbalance
    /// @throws SolverError if it does not converge
    Eigen::VectorXd solve(Eigen::VectorXd d, double tolerance) const;

  private:
    Eigen::VectorXd imbalance(const Eigen::VectorXd& d) const;

    LinearisedStructure& structure_;
    WoodburySolver& steps_;
    const Eigen::VectorXd& loads_;
    const Eigen::VectorXd& xOfLoads_;
    const LowRankMatrix& J_;
};

} // namespace tokay::coupling
