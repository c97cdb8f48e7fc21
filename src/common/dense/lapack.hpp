// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <lapacke.h>

namespace tokay {

/// Number of rows or columns as LAPACK counts.
/// @throws SolverError if it has no such number
lapack_int lapackSize(Eigen::Index n);

/// @throws SolverError if an entry is not finite
void requireFinite(const Eigen::MatrixXd& A);

/// @param routine  LAPACK's name
/// @param status   what it returned for a matrix of m x n
/// @throws SolverError if it did not converge or lacked memory
void requireLapack(const char* routine, lapack_int m, lapack_int n, lapack_int status);

} // namespace tokay
