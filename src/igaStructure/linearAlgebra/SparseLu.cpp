// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/linearAlgebra/SparseLu.hpp"

#include "common/dense/blas.hpp"
#include "igaStructure/linearAlgebra/FreePart.hpp"

#include <fmt/format.h>
#include <umfpack.h>

#include <cassert>
#include <limits>

namespace tokay::structure {

struct SparseLu::Implementation {
    FreePart part;
    std::vector<double> values;
    double control[UMFPACK_CONTROL] = {};
    double info[UMFPACK_INFO] = {};
    void* symbolic = nullptr;
    void* numeric = nullptr;

    Implementation(const SparseMatrix& pattern, const std::vector<bool>& fixed)
        : part(pattern, fixed, Triangles::both), values(part.nEntries()) {
        umfpack_di_defaults(control);
        control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC; // the sparsity is
        require(umfpack_di_symbolic(part.size(), part.size(), part.starts().data(),
                                    part.rows().data(), nullptr, &symbolic, control, info),
                "analysis");
    }
    ~Implementation() {
        umfpack_di_free_numeric(&numeric);
        umfpack_di_free_symbolic(&symbolic);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    void require(int status, const char* doing) const {
        if (status == UMFPACK_WARNING_singular_matrix) {
            throw SingularMatrix(fmt::format("the matrix of {} unknowns is singular", part.size()));
        }
        if (status == UMFPACK_ERROR_out_of_memory) {
            throw SolverError(fmt::format("not enough memory for UMFPACK's {} of {} unknowns; use "
                                          "fewer elements or a lower degree",
                                          doing, part.size()));
        }
        if (status != UMFPACK_OK) {
            throw SolverError(fmt::format("UMFPACK's {} ended with status {} (matrix of {} "
                                          "unknowns)",
                                          doing, status, part.size()));
        }
    }
};

SparseLu::SparseLu(const SparseMatrix& pattern, const std::vector<bool>& fixed)
    : implementation_(std::make_unique<Implementation>(pattern, fixed)) {}

SparseLu::SparseLu(SparseLu&&) noexcept = default;
SparseLu::~SparseLu() = default;

void SparseLu::factorise(const SparseMatrix& matrix) {
    Implementation& own = *implementation_;
    const BlasThreads threads(own.info[UMFPACK_FLOPS_ESTIMATE]);
    umfpack_di_free_numeric(&own.numeric);
    own.part.setScaled(matrix, own.values.data());
    own.require(umfpack_di_numeric(own.part.starts().data(), own.part.rows().data(),
                                   own.values.data(), own.symbolic, &own.numeric, own.control,
                                   own.info),
                "factorisation");
    // A singular matrix whose last pivot is rounding error passes as regular.
    if (own.info[UMFPACK_RCOND] < std::numeric_limits<double>::epsilon()) {
        umfpack_di_free_numeric(&own.numeric);
        throw SingularMatrix(fmt::format("the matrix of {} unknowns is singular (smallest over "
                                         "largest pivot {:.1e})",
                                         nFree(), own.info[UMFPACK_RCOND]));
    }
}

Eigen::MatrixXd SparseLu::solveAll(const Eigen::MatrixXd& rightHandSides) {
    Implementation& own = *implementation_;
    assert(own.numeric);
    Eigen::VectorXd b(nFree());
    Eigen::VectorXd x(nFree());
    Eigen::MatrixXd result(rightHandSides.rows(), rightHandSides.cols());
    for (Eigen::Index k = 0; k < rightHandSides.cols(); ++k) {
        own.part.reduce(rightHandSides.col(k), b.data());
        own.require(umfpack_di_solve(UMFPACK_A, own.part.starts().data(), own.part.rows().data(),
                                     own.values.data(), x.data(), b.data(), own.numeric,
                                     own.control, own.info),
                    "solution");
        result.col(k) = own.part.extend(x.data());
    }
    return result;
}

int SparseLu::nFree() const {
    return implementation_->part.size();
}

double SparseLu::nFactorEntries() const {
    const double* info = implementation_->info;
    return implementation_->numeric ? info[UMFPACK_LNZ] + info[UMFPACK_UNZ]
                                    : info[UMFPACK_LNZ_ESTIMATE] + info[UMFPACK_UNZ_ESTIMATE];
}

double SparseLu::bytes() const {
    return sizeof(double) * nFactorEntries() + implementation_->part.bytes();
}

} // namespace tokay::structure
