// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

namespace tokay::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

} // namespace tokay::structure
