#include "igaStructure/linearAlgebra/SparseLu.hpp"

#include "common/errors.hpp"

#include <Eigen/UmfPackSupport>
#include <fmt/format.h>

namespace tokay::structure {

struct SparseLu::Implementation {
    std::vector<int> freeUnknowns;
    std::vector<int> numbers; ///< of free unknowns, -1 for fixed ones
    SparseMatrix matrix;      ///< UMFPACK refers to it
    Eigen::UmfPackLU<SparseMatrix> lu;
};

SparseLu::SparseLu(const std::vector<bool>& fixed)
    : implementation_(std::make_unique<Implementation>()) {
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        implementation_->numbers.push_back(
            fixed[k] ? -1 : static_cast<int>(implementation_->freeUnknowns.size()));
        if (!fixed[k]) {
            implementation_->freeUnknowns.push_back(static_cast<int>(k));
        }
    }
}

SparseLu::SparseLu(SparseLu&&) noexcept = default;
SparseLu::~SparseLu() = default;

void SparseLu::factorise(const SparseMatrix& full) {
    Implementation& own = *implementation_;
    std::vector<Eigen::Triplet<double>> entries;
    for (int column : own.freeUnknowns) {
        for (SparseMatrix::InnerIterator entry(full, column); entry; ++entry) {
            if (own.numbers[entry.row()] >= 0) {
                entries.emplace_back(own.numbers[entry.row()], own.numbers[column], entry.value());
            }
        }
    }
    const auto n = static_cast<Eigen::Index>(own.freeUnknowns.size());
    own.matrix.resize(n, n);
    own.matrix.setFromTriplets(entries.begin(), entries.end());
    own.lu.compute(own.matrix);
    if (own.lu.info() != Eigen::Success) {
        throw SolverError(fmt::format("UMFPACK cannot factor a matrix of {} unknowns (status {}): "
                                      "it is singular",
                                      n, own.lu.umfpackFactorizeReturncode()));
    }
}

Eigen::VectorXd SparseLu::solve(const Eigen::VectorXd& rightHandSide) const {
    const Implementation& own = *implementation_;
    const Eigen::VectorXd reduced = rightHandSide(own.freeUnknowns);
    const Eigen::VectorXd solution = own.lu.solve(reduced);
    Eigen::VectorXd full = Eigen::VectorXd::Zero(rightHandSide.size());
    full(own.freeUnknowns) = solution;
    return full;
}

} // namespace tokay::structure
