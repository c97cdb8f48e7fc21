// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay {

/// Eigenvalues and eigenvectors A = vectors diag(values) vectors^T of a dense symmetric
/// matrix, n x n, by QR iteration (LAPACK's dsyev).
struct SymmetricEigen {
    /// @param A  its lower triangle is read
    /// @throws SolverError if an entry is not finite
    explicit SymmetricEigen(const Eigen::MatrixXd& A);

    Eigen::VectorXd values;  ///< ascending
    Eigen::MatrixXd vectors; ///< orthonormal columns
};

} // namespace tokay
