// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay {

/// A = Q R of a dense matrix, m x n, by Householder reflections (LAPACK's dgeqrf and dorgqr).
struct ThinQr {
    /// @throws SolverError if an entry is not finite
    explicit ThinQr(const Eigen::MatrixXd& A);

    Eigen::MatrixXd Q; ///< m x min(m, n), orthonormal columns
    Eigen::MatrixXd R; ///< min(m, n) x n, upper triangular
};

} // namespace tokay
