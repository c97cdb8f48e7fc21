// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay {

/// P A = L U of a dense square matrix, n x n, with exchanges of rows (LAPACK's dgetrf).
class DenseLu {
  public:
    DenseLu() = default;
    /// @param A  if it is singular, solutions are not finite
    explicit DenseLu(Eigen::MatrixXd A);

    /// Solution of A x = b.
    /// @param b  n x m
    Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const { return solve('N', b); }
    /// Solution of A^T x = b.
    Eigen::MatrixXd solveTransposed(const Eigen::MatrixXd& b) const { return solve('T', b); }

    /// L below the diagonal, which is 1; U on and above it.
    const Eigen::MatrixXd& factors() const { return factors_; }
    /// The rows of A in the order of the factors.
    Eigen::VectorXi rows() const;

  private:
    Eigen::MatrixXd solve(char transpose, const Eigen::MatrixXd& b) const;

    Eigen::MatrixXd factors_;
    Eigen::VectorXi exchanges_; ///< row k with this one, counted from 1, one after the other
};

} // namespace tokay
