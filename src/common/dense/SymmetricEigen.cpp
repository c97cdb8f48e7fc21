// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/SymmetricEigen.hpp"

#include "common/dense/blas.hpp"
#include "common/dense/lapack.hpp"

#include <cassert>

namespace tokay {

SymmetricEigen::SymmetricEigen(const Eigen::MatrixXd& A) : values(A.rows()), vectors(A) {
    assert(A.rows() == A.cols());
    requireFinite(A);
    if (A.size() == 0) {
        return;
    }
    const lapack_int n = lapackSize(A.rows());
    const BlasThreads threads(9.0 * n * n * n);
    requireLapack("dsyev", n, n,
                  LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', n, vectors.data(), n, values.data()));
}

} // namespace tokay
