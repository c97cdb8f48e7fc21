// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"

#include <algorithm>
#include <limits>

namespace tokay::structure {

/// Rounding error of the product of a matrix and a vector whose largest entry is 1.
inline double roundingOf(const SparseMatrix& matrix) {
    return std::numeric_limits<double>::epsilon() * Eigen::VectorXd(matrix.diagonal()).norm();
}

/// Norm of the internal forces' rounding error: no residual gets below it, however small
/// the tolerance. Thin bodies come near it: their stretching forces are differences of
/// numbers that are larger by orders of magnitude.
class RoundingFloor {
  public:
    /// @param stiffness  at rest
    RoundingFloor(const SparseMatrix& stiffness, double size)
        : perDisplacement_(roundingOf(stiffness)), least_(leastDisplacement * size) {}

    /// [N]
    double at(const Eigen::VectorXd& displacement) const {
        return perDisplacement_ * std::max(displacement.lpNorm<Eigen::Infinity>(), least_);
    }

  private:
    /// Displacements below this fraction of the structure's size count as none.
    static constexpr double leastDisplacement = 1e-15;

    double perDisplacement_; ///< [N/m]
    double least_;           ///< [m]
};

} // namespace tokay::structure
