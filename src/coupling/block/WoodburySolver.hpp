// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/block/GrowingLu.hpp"
#include "coupling/history/LowRankMatrix.hpp"
#include "coupling/step/CoupledStructure.hpp"

#include <cstdint>
#include <vector>

namespace tokay::coupling {

/// Solves (K - A Bᵀ P) d = b, a structure's tangent K in a fluid that responds to the
/// motion P d of its interface by A Bᵀ, of small rank:
///   d = y + K⁻¹ A c,  (1 - Bᵀ P K⁻¹ A) c = Bᵀ P y,  y = K⁻¹ b.
/// The capacitance matrix 1 - Bᵀ P K⁻¹ A, which takes a back-substitution for each column
/// of A, is kept with its factors from one call to the next: for a linear structure these get
/// only the columns that are new, for another one it serves to refine c as long as K and P have
/// changed little. A call then takes two back-substitutions, and one for each refinement. Source:
/// Hager 1989, Updating the inverse of a matrix, SIAM Review 31.
class WoodburySolver {
  public:
    /// Borrows the structure.
    explicit WoodburySolver(LinearisedStructure& structure) : structure_(structure) {}

    /// @param J  A Bᵀ
    /// @param b  N
    /// @return   d, with K and P of the structure's last linearise(); the equation of c holds to
    ///           a relative 1e-6, or to what rounding leaves of it
    Eigen::VectorXd solve(const LowRankMatrix& J, const Eigen::VectorXd& b);

    /// The next call depends on its arguments alone.
    void forget() { kept_.clear(); }

  private:
    struct Refined {
        Eigen::VectorXd driven; ///< K⁻¹ A c
        bool converged;
    };

    Refined refine(const LowRankMatrix& J, const Eigen::VectorXd& rightHandSide);
    int update(const LowRankMatrix& J);
    int nEqualColumns(const LowRankMatrix& J) const;

    LinearisedStructure& structure_;
    std::vector<std::uint64_t> kept_; ///< marks of the columns that what follows belongs to
    Eigen::MatrixXd PZ_;              ///< P K⁻¹ A, each column with the K of its time
    GrowingLu capacitance_;
};

} // namespace tokay::coupling
