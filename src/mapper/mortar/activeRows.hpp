// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"

#include <vector>

namespace tokay::mapper {

/// Numbers of the rows that hold a number other than 0, ascending.
std::vector<int> rowsNotZero(const RowSparseMatrix& matrix);

/// The rows and columns that are active, in their order.
Eigen::SparseMatrix<double> restricted(const RowSparseMatrix& matrix,
                                       const std::vector<int>& active);

} // namespace tokay::mapper
