// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/ThinQr.hpp"

#include "common/dense/blas.hpp"
#include "common/dense/lapack.hpp"

#include <algorithm>

namespace tokay {

ThinQr::ThinQr(const Eigen::MatrixXd& A) {
    requireFinite(A);
    const lapack_int m = lapackSize(A.rows()), n = lapackSize(A.cols()), k = std::min(m, n);
    Eigen::MatrixXd factors = A;
    if (k > 0) {
        Eigen::VectorXd scales(k);
        const BlasThreads threads(4.0 * m * n * k);
        requireLapack("dgeqrf", m, n,
                      LAPACKE_dgeqrf(LAPACK_COL_MAJOR, m, n, factors.data(), m, scales.data()));
        R = factors.topRows(k).triangularView<Eigen::Upper>();
        requireLapack("dorgqr", m, k,
                      LAPACKE_dorgqr(LAPACK_COL_MAJOR, m, k, k, factors.data(), m, scales.data()));
    } else {
        R.resize(0, n);
    }
    Q = factors.leftCols(k);
}

} // namespace tokay
