// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

namespace tokay::mapper {

using RowSparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Storage of the matrix [byte].
inline double bytesOf(const RowSparseMatrix& matrix) {
    return static_cast<double>(matrix.nonZeros()) * (sizeof(double) + sizeof(int)) +
           static_cast<double>(matrix.outerSize() + 1) * sizeof(int);
}

} // namespace tokay::mapper
