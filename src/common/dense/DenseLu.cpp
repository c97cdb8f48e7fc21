// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/DenseLu.hpp"

#include "common/dense/blas.hpp"
#include "common/dense/lapack.hpp"

#include <cassert>
#include <type_traits>
#include <utility>

namespace tokay {

static_assert(std::is_same_v<lapack_int, int>, "exchanges are LAPACK's");

DenseLu::DenseLu(Eigen::MatrixXd A) : factors_(std::move(A)), exchanges_(factors_.rows()) {
    assert(factors_.rows() == factors_.cols());
    if (factors_.size() > 0) {
        const lapack_int n = lapackSize(factors_.rows());
        const BlasThreads threads(2. / 3 * n * n * n);
        // Its status says whether a pivot is zero; the solution does so too
        LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, n, n, factors_.data(), n, exchanges_.data());
    }
}

Eigen::MatrixXd DenseLu::solve(char transpose, const Eigen::MatrixXd& b) const {
    assert(b.rows() == factors_.rows());
    Eigen::MatrixXd x = b;
    if (x.size() > 0) {
        const lapack_int n = lapackSize(b.rows()), m = lapackSize(b.cols());
        const BlasThreads threads(2.0 * n * n * m);
        LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, transpose, n, m, factors_.data(), n,
                            exchanges_.data(), x.data(), n);
    }
    return x;
}

Eigen::VectorXi DenseLu::rows() const {
    Eigen::VectorXi rows =
        Eigen::VectorXi::LinSpaced(exchanges_.size(), 0, static_cast<int>(exchanges_.size()) - 1);
    for (Eigen::Index k = 0; k < rows.size(); ++k) {
        std::swap(rows[k], rows[exchanges_[k] - 1]);
    }
    return rows;
}

} // namespace tokay
