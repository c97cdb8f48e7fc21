// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/linearAlgebra/SparseCholesky.hpp"

#include "common/dense/blas.hpp"
#include "igaStructure/linearAlgebra/FreePart.hpp"

#include <cholmod.h>
#include <fmt/format.h>

#include <cassert>
#include <limits>

namespace tokay::structure {

struct SparseCholesky::Implementation {
    FreePart part;
    cholmod_common common{};
    cholmod_sparse* matrix = nullptr; ///< lower triangle of the free unknowns
    cholmod_factor* factor = nullptr;
    cholmod_dense* rightHandSides = nullptr;
    cholmod_dense* solutions = nullptr;
    cholmod_dense* workspaceY = nullptr;
    cholmod_dense* workspaceE = nullptr;
    double nOperations = 0; ///< of a factorisation
    bool factorised = false;

    Implementation(const SparseMatrix& pattern, const std::vector<bool>& fixed)
        : part(pattern, fixed, Triangles::lower) {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.print = 0; // every status is checked instead
        const auto n = static_cast<std::size_t>(part.size());
        matrix = cholmod_allocate_sparse(n, n, part.nEntries(), 1, 1, -1, CHOLMOD_REAL, &common);
        requireOk("allocation");
        std::copy(part.starts().begin(), part.starts().end(), static_cast<int*>(matrix->p));
        std::copy(part.rows().begin(), part.rows().end(), static_cast<int*>(matrix->i));
    }
    ~Implementation() {
        cholmod_free_dense(&workspaceE, &common);
        cholmod_free_dense(&workspaceY, &common);
        cholmod_free_dense(&solutions, &common);
        cholmod_free_dense(&rightHandSides, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_free_sparse(&matrix, &common);
        cholmod_finish(&common);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    void requireOk(const char* doing) const {
        if (common.status == CHOLMOD_OK) {
            return;
        }
        if (common.status == CHOLMOD_OUT_OF_MEMORY) {
            throw SolverError(fmt::format("not enough memory for {} of {} unknowns; use fewer "
                                          "elements or a lower degree",
                                          doing, part.size()));
        }
        if (common.status == CHOLMOD_NOT_POSDEF) {
            throw notPositiveDefinite();
        }
        throw SolverError(fmt::format("CHOLMOD's {} ended with status {} (matrix of {} unknowns)",
                                      doing, common.status, part.size()));
    }

    NotPositiveDefinite notPositiveDefinite() const {
        const auto column = static_cast<int>(factor->minor);
        const auto* order = static_cast<const int*>(factor->Perm);
        const int unknown = part.unknown(order[std::min(column, part.size() - 1)]);
        return {unknown, fmt::format("the matrix is not positive definite (pivot {} of {}, "
                                     "unknown {})",
                                     column + 1, part.size(), unknown)};
    }
};

SparseCholesky::SparseCholesky(const SparseMatrix& pattern, const std::vector<bool>& fixed)
    : implementation_(std::make_unique<Implementation>(pattern, fixed)) {
    Implementation& own = *implementation_;
    own.factor = cholmod_analyze(own.matrix, &own.common);
    own.requireOk("analysis");
    own.nOperations = own.common.fl;
}

SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::factorise(const SparseMatrix& matrix) {
    Implementation& own = *implementation_;
    const BlasThreads threads(own.nOperations);
    own.factorised = false;
    own.part.setScaled(matrix, static_cast<double*>(own.matrix->x));
    cholmod_factorize(own.matrix, own.factor, &own.common);
    own.requireOk("factorisation");
    // A singular matrix whose last pivot is rounding error passes as positive.
    if (cholmod_rcond(own.factor, &own.common) < std::numeric_limits<double>::epsilon() / 100) {
        own.factor->minor = own.factor->n - 1;
        throw own.notPositiveDefinite();
    }
    own.factorised = true;
}

Eigen::MatrixXd SparseCholesky::solveAll(const Eigen::MatrixXd& rightHandSides) {
    Implementation& own = *implementation_;
    assert(own.factorised);
    const Eigen::Index nColumns = rightHandSides.cols();
    const auto n = static_cast<std::size_t>(nFree());
    const BlasThreads threads(4 * nFactorEntries() * static_cast<double>(nColumns));
    cholmod_ensure_dense(&own.rightHandSides, n, static_cast<std::size_t>(nColumns), n,
                         CHOLMOD_REAL, &own.common);
    own.requireOk("allocation");
    for (Eigen::Index k = 0; k < nColumns; ++k) {
        own.part.reduce(rightHandSides.col(k),
                        static_cast<double*>(own.rightHandSides->x) + k * nFree());
    }
    cholmod_solve2(CHOLMOD_A, own.factor, own.rightHandSides, nullptr, &own.solutions, nullptr,
                   &own.workspaceY, &own.workspaceE, &own.common);
    own.requireOk("solution");
    Eigen::MatrixXd result(rightHandSides.rows(), nColumns);
    for (Eigen::Index k = 0; k < nColumns; ++k) {
        result.col(k) = own.part.extend(static_cast<const double*>(own.solutions->x) + k * nFree());
    }
    return result;
}

int SparseCholesky::nFree() const {
    return implementation_->part.size();
}

double SparseCholesky::nFactorEntries() const {
    // Known from the analysis, in the order that it chose last.
    return implementation_->common.lnz;
}

double SparseCholesky::bytes() const {
    return sizeof(double) * nFactorEntries() + implementation_->part.bytes();
}

} // namespace tokay::structure
