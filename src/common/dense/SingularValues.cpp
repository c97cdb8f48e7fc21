// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/SingularValues.hpp"

#include "common/dense/blas.hpp"
#include "common/dense/lapack.hpp"

#include <algorithm>

namespace tokay {

SingularValues::SingularValues(const Eigen::MatrixXd& A)
    : U(A.rows(), std::min(A.rows(), A.cols())), values(U.cols()) {
    requireFinite(A);
    if (A.size() == 0) {
        V.setIdentity(A.cols(), A.cols());
        return;
    }
    const lapack_int m = lapackSize(A.rows()), n = lapackSize(A.cols());
    // All of V: in the thin form it has as many columns as there are values
    const char form = m < n ? 'A' : 'S';
    Eigen::MatrixXd destroyed = A, transposed(n, n);
    const BlasThreads threads(10.0 * m * n * std::min(m, n));
    requireLapack("dgesdd", m, n,
                  LAPACKE_dgesdd(LAPACK_COL_MAJOR, form, m, n, destroyed.data(), m, values.data(),
                                 U.data(), m, transposed.data(), n));
    V = transposed.transpose();
}

Eigen::Index SingularValues::rank(double relativeLimit) const {
    return values.size() == 0 ? 0 : (values.array() > relativeLimit * values[0]).count();
}

} // namespace tokay
