// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/linearAlgebra/ExtendedSolver.hpp"
#include "igaStructure/linearAlgebra/SparseCholesky.hpp"
#include "igaStructure/linearAlgebra/SparseLu.hpp"

namespace tokay::structure {

std::unique_ptr<LinearSolver> makeLinearSolver(const SparseMatrix& pattern,
                                               const std::vector<bool>& fixed, MatrixKind kind,
                                               const SparseMatrix* extension) {
    if (extension) {
        return std::make_unique<ExtendedSolver>(pattern, fixed, *extension);
    }
    if (kind == MatrixKind::positiveDefinite) {
        return std::make_unique<SparseCholesky>(pattern, fixed);
    }
    return std::make_unique<SparseLu>(pattern, fixed);
}

} // namespace tokay::structure
