// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/lapack.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <cassert>
#include <limits>

namespace tokay {

lapack_int lapackSize(Eigen::Index n) {
    if (n > std::numeric_limits<lapack_int>::max()) {
        throw SolverError(fmt::format("a dense matrix of {} rows or columns is too large", n));
    }
    return static_cast<lapack_int>(n);
}

void requireFinite(const Eigen::MatrixXd& A) {
    if (!A.allFinite()) {
        throw SolverError(
            fmt::format("a matrix of {} x {} has entries that are not finite", A.rows(), A.cols()));
    }
}

void requireLapack(const char* routine, lapack_int m, lapack_int n, lapack_int status) {
    if (status == LAPACK_WORK_MEMORY_ERROR) {
        throw SolverError(fmt::format("not enough memory to decompose a matrix of {} x {}", m, n));
    }
    assert(status >= 0); // else an argument is wrong
    if (status > 0) {
        throw SolverError(fmt::format("the decomposition of a matrix of {} x {} did not converge "
                                      "({}: {})",
                                      m, n, routine, status));
    }
}

} // namespace tokay
