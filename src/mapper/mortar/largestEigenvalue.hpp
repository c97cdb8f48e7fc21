// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace tokay::mapper {

/// Largest eigenvalue, to about 1e-3 of it, of a symmetric operator on n numbers
/// without negative ones; infinite if the operator gives what is not finite.
/// Source: Golub & Van Loan, Matrix Computations, section 10.1 (Lanczos)
double largestEigenvalue(Eigen::Index n,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply);

} // namespace tokay::mapper
