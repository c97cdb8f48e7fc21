// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/linearAlgebra/SparseCholesky.hpp"
#include "igaStructure/linearAlgebra/SparseLu.hpp"

namespace tokay::structure {

std::unique_ptr<LinearSolver> makeLinearSolver(const SparseMatrix& pattern,
                                               const std::vector<bool>& fixed, MatrixKind kind) {
    if (kind == MatrixKind::positiveDefinite) {
        return std::make_unique<SparseCholesky>(pattern, fixed);
    }
    return std::make_unique<SparseLu>(pattern, fixed);
}

} // namespace tokay::structure
