// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::coupling {

/// LU factors of a matrix that grows by rows and columns at its end: k more of them take
/// O(n² k) operations instead of the O(n³) of new factors. Rows are exchanged among those
/// that were appended together, so that a matrix with a nearly singular leading block is
/// solved with fewer digits than one that was appended as a whole.
class GrowingLu {
  public:
    /// Number of rows and columns.
    Eigen::Index size() const { return lu_.rows(); }

    void clear() { lu_.resize(0, 0); }

    /// Makes [A, right; bottom, corner] of a matrix A, n x n.
    /// @param right   n x k
    /// @param bottom  k x n
    /// @param corner  k x k
    void append(const Eigen::MatrixXd& right, const Eigen::MatrixXd& bottom,
                const Eigen::MatrixXd& corner);

    /// Solution of A x = b; not finite if A is singular.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  private:
    Eigen::MatrixXd lu_;   ///< L below the diagonal, which is 1; U on and above it
    Eigen::VectorXi rows_; ///< of the matrix, in the order of the factors
};

} // namespace tokay::coupling
