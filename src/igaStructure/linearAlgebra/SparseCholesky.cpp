#include "igaStructure/linearAlgebra/SparseCholesky.hpp"

#include <cholmod.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace tokay::structure {

struct SparseCholesky::Implementation {
    cholmod_common common{};
    cholmod_sparse* matrix = nullptr; ///< lower triangle of the free unknowns
    cholmod_factor* factor = nullptr;
    cholmod_dense* rightHandSide = nullptr;
    cholmod_dense* solution = nullptr;
    cholmod_dense* workspaceY = nullptr;
    cholmod_dense* workspaceE = nullptr;
    std::vector<int> freeUnknowns;
    std::vector<int> slots;     ///< in the full matrix, of each entry of `matrix`
    std::vector<double> scales; ///< of each free unknown
    bool factorised = false;

    Implementation() {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.print = 0; // every status is checked instead
    }
    ~Implementation() {
        cholmod_free_dense(&workspaceE, &common);
        cholmod_free_dense(&workspaceY, &common);
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&rightHandSide, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_free_sparse(&matrix, &common);
        cholmod_finish(&common);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    int nFree() const { return static_cast<int>(freeUnknowns.size()); }

    void requireOk(const char* doing) const {
        if (common.status == CHOLMOD_OK) {
            return;
        }
        if (common.status == CHOLMOD_OUT_OF_MEMORY) {
            throw SolverError(fmt::format("not enough memory for {} of {} unknowns; use fewer "
                                          "elements or a lower degree",
                                          doing, nFree()));
        }
        if (common.status == CHOLMOD_NOT_POSDEF) {
            throw notPositiveDefinite();
        }
        throw SolverError(fmt::format("CHOLMOD's {} ended with status {} (matrix of {} unknowns)",
                                      doing, common.status, nFree()));
    }

    NotPositiveDefinite notPositiveDefinite() const {
        const auto column = static_cast<int>(factor->minor);
        const auto* order = static_cast<const int*>(factor->Perm);
        const int unknown = freeUnknowns[order[std::min(column, nFree() - 1)]];
        return {unknown, fmt::format("the matrix is not positive definite (pivot {} of {}, "
                                     "unknown {})",
                                     column + 1, nFree(), unknown)};
    }

    // Unknowns scaled so that diagonal entries are one: functions of which trimming
    // has left a sliver are as good as others then.
    void setScaledValues(const SparseMatrix& full) {
        const auto* starts = static_cast<const int*>(matrix->p);
        const auto* rows = static_cast<const int*>(matrix->i);
        auto* values = static_cast<double*>(matrix->x);
        scales.assign(nFree(), 1);
        for (int k = 0; k < nFree(); ++k) {
            const double diagonal = full.valuePtr()[slots[starts[k]]];
            if (diagonal > 0) {
                scales[k] = 1 / std::sqrt(diagonal);
            }
        }
        for (int column = 0; column < nFree(); ++column) {
            for (int k = starts[column]; k < starts[column + 1]; ++k) {
                values[k] = scales[column] * full.valuePtr()[slots[k]] * scales[rows[k]];
            }
        }
    }

    void selectLowerTriangle(const SparseMatrix& full, const std::vector<bool>& fixed) {
        std::vector<int> number(full.cols(), -1);
        for (int k = 0; k < full.cols(); ++k) {
            if (!fixed[k]) {
                number[k] = nFree();
                freeUnknowns.push_back(k);
            }
        }
        std::vector<int> starts{0};
        std::vector<int> rows;
        for (int column : freeUnknowns) {
            for (int slot = full.outerIndexPtr()[column]; slot < full.outerIndexPtr()[column + 1];
                 ++slot) {
                const int row = full.innerIndexPtr()[slot];
                if (row >= column && !fixed[row]) {
                    rows.push_back(number[row]);
                    slots.push_back(slot);
                }
            }
            starts.push_back(static_cast<int>(rows.size()));
        }
        const std::size_t n = freeUnknowns.size();
        matrix = cholmod_allocate_sparse(n, n, rows.size(), 1, 1, -1, CHOLMOD_REAL, &common);
        requireOk("allocation");
        std::copy(starts.begin(), starts.end(), static_cast<int*>(matrix->p));
        std::copy(rows.begin(), rows.end(), static_cast<int*>(matrix->i));
    }
};

SparseCholesky::SparseCholesky(const SparseMatrix& pattern, const std::vector<bool>& fixed)
    : implementation_(std::make_unique<Implementation>()) {
    Implementation& own = *implementation_;
    own.selectLowerTriangle(pattern, fixed);
    if (own.nFree() == 0) {
        throw SolverError("the supports fix every unknown; nothing is left to solve");
    }
    own.factor = cholmod_analyze(own.matrix, &own.common);
    own.requireOk("analysis");
    own.rightHandSide =
        cholmod_allocate_dense(own.nFree(), 1, own.nFree(), CHOLMOD_REAL, &own.common);
    own.requireOk("allocation");
}

SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::factorise(const SparseMatrix& full) {
    Implementation& own = *implementation_;
    own.factorised = false;
    own.setScaledValues(full);
    cholmod_factorize(own.matrix, own.factor, &own.common);
    own.requireOk("factorisation");
    // A singular matrix whose last pivot is rounding error passes as positive.
    if (cholmod_rcond(own.factor, &own.common) < std::numeric_limits<double>::epsilon() / 100) {
        own.factor->minor = own.factor->n - 1;
        throw own.notPositiveDefinite();
    }
    own.factorised = true;
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& rightHandSide) {
    Implementation& own = *implementation_;
    assert(own.factorised);
    auto* b = static_cast<double*>(own.rightHandSide->x);
    for (int k = 0; k < own.nFree(); ++k) {
        b[k] = own.scales[k] * rightHandSide[own.freeUnknowns[k]];
    }
    cholmod_solve2(CHOLMOD_A, own.factor, own.rightHandSide, nullptr, &own.solution, nullptr,
                   &own.workspaceY, &own.workspaceE, &own.common);
    own.requireOk("solution");
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(rightHandSide.size());
    const auto* x = static_cast<const double*>(own.solution->x);
    for (int k = 0; k < own.nFree(); ++k) {
        solution[own.freeUnknowns[k]] = own.scales[k] * x[k];
    }
    return solution;
}

int SparseCholesky::nFree() const {
    return implementation_->nFree();
}

double SparseCholesky::nFactorEntries() const {
    // Known from the analysis, in the order that it chose last.
    return implementation_->common.lnz;
}

double SparseCholesky::bytes() const {
    constexpr double perEntry = sizeof(double) + sizeof(int);
    return sizeof(double) * nFactorEntries() +
           (perEntry + sizeof(int)) * static_cast<double>(implementation_->slots.size());
}

std::string blasLibrary() {
    void* symbol = dlsym(RTLD_DEFAULT, "dgemm_");
    Dl_info info;
    if (!symbol || !dladdr(symbol, &info)) {
        return "unknown";
    }
    std::unique_ptr<char, decltype(&std::free)> path(realpath(info.dli_fname, nullptr), &std::free);
    return path ? path.get() : info.dli_fname;
}

} // namespace tokay::structure
