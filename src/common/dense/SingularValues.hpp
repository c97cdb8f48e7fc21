// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay {

/// Singular value decomposition A = U diag(values) V^T of a dense matrix, m x n, by divide and
/// conquer (Gu & Eisenstat 1995; LAPACK's dgesdd).
struct SingularValues {
    /// @throws SolverError if an entry is not finite
    explicit SingularValues(const Eigen::MatrixXd& A);

    /// How many of the values are larger than this part of the largest one.
    Eigen::Index rank(double relativeLimit) const;

    Eigen::MatrixXd U;      ///< m x min(m, n)
    Eigen::VectorXd values; ///< min(m, n), descending
    Eigen::MatrixXd V;      ///< n x n
};

} // namespace tokay
