// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/MassInverse.hpp"

#include "common/errors.hpp"
#include "mapper/mortar/GradientExtension.hpp"
#include "mapper/mortar/activeRows.hpp"
#include "mapper/mortar/largestEigenvalue.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/SPQRSupport>
#include <fmt/format.h>

namespace tokay::mapper {

using ColumnMatrix = Eigen::SparseMatrix<double>;

class MassInverse::Factorisation {
  public:
    virtual ~Factorisation() = default;
    virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const = 0;

    /// @param matrix  that was factorised
    double condition(const ColumnMatrix& matrix) const {
        const auto forwards = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
            return matrix * v;
        };
        const auto backwards = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
            return solve(v);
        };
        return largestEigenvalue(matrix.rows(), forwards) *
               largestEigenvalue(matrix.rows(), backwards);
    }
};

class MassInverse::Cholesky : public Factorisation {
  public:
    explicit Cholesky(const ColumnMatrix& matrix) {
        solver_.cholmod().print = 0; // a failure is reported by succeeded()
        solver_.compute(matrix);
    }
    bool succeeded() const { return solver_.info() == Eigen::Success; }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const override { return solver_.solve(rhs); }

  private:
    Eigen::CholmodSupernodalLLT<ColumnMatrix> solver_;
};

/// Complete orthogonal decomposition: A P = Q R with R of rank rows, and the
/// transpose of R decomposed again, gives the solution of least norm.
/// Source: Golub & Van Loan, Matrix Computations, section 5.5.2
class MassInverse::PseudoInverse : public Factorisation {
  public:
    explicit PseudoInverse(const ColumnMatrix& matrix) {
        decompose(first_, matrix);
        rank_ = static_cast<int>(first_.rank());
        const ColumnMatrix rows = ColumnMatrix(first_.matrixR()).topRows(rank_);
        second_.setPivotThreshold(0); // the rank is told once
        decompose(second_, rows.transpose());
        if (second_.rank() != rank_) {
            throw SolverError(
                fmt::format("the mass matrix has rank {} by its columns and {} by its "
                            "rows",
                            rank_, second_.rank()));
        }
        triangle_ = ColumnMatrix(second_.matrixR()).topLeftCorner(rank_, rank_);
    }
    int rank() const { return rank_; }

    Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const override {
        const Eigen::MatrixXd projected = first_.matrixQ().transpose() * rhs;
        const Eigen::MatrixXd permuted =
            second_.colsPermutation().transpose() * projected.topRows(rank_);
        Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(rhs.rows(), rhs.cols());
        padded.topRows(rank_) =
            triangle_.transpose().triangularView<Eigen::Lower>().solve(permuted);
        const Eigen::MatrixXd rotated = second_.matrixQ() * padded;
        return first_.colsPermutation() * rotated;
    }

  private:
    static void decompose(Eigen::SPQR<ColumnMatrix>& qr, const ColumnMatrix& matrix) {
        qr.compute(matrix);
        if (qr.info() != Eigen::Success) {
            throw SolverError("the QR decomposition of the mass matrix failed (SPQR)");
        }
    }

    Eigen::SPQR<ColumnMatrix> first_, second_;
    ColumnMatrix triangle_;
    int rank_;
};

MassInverse::MassInverse(const RowSparseMatrix& matrix, SingularMass singular,
                         const RowSparseMatrix& gradientTerm)
    : n_(static_cast<int>(matrix.rows())), active_(rowsNotZero(matrix)) {
    if (active_.empty()) {
        throw SolverError("the mass matrix is zero: the two sides of the interface do "
                          "not meet");
    }
    // Beyond this condition Cholesky's solution has no digit that SPQR would call certain.
    constexpr double largestCondition = 1e13;
    const ColumnMatrix reduced = restricted(matrix, active_);
    auto cholesky = std::make_unique<Cholesky>(reduced);
    if (cholesky->succeeded()) {
        condition_ = cholesky->condition(reduced);
        if (condition_ < largestCondition) {
            rank_ = nActive();
            factorisation_ = std::move(cholesky);
            return;
        }
    }
    auto pseudoInverse = std::make_unique<PseudoInverse>(reduced);
    rank_ = pseudoInverse->rank();
    if (rank_ < nActive() && singular == SingularMass::refuse) {
        throw SolverError(fmt::format("the mass matrix of the destination is singular: {} "
                                      "functions reach the interface, but their traces span only "
                                      "{} dimensions (a trimmed edge does that); choose the "
                                      "minimum norm solution or the gradient term, or map to an "
                                      "edge that the basis interpolates",
                                      nActive(), rank_));
    }
    condition_ = pseudoInverse->condition(reduced);
    factorisation_ = std::move(pseudoInverse);
    if (isSingular() && singular == SingularMass::gradientTerm) {
        extension_ = std::make_unique<GradientExtension>(matrix, gradientTerm);
    }
}

MassInverse::~MassInverse() = default;
MassInverse::MassInverse(MassInverse&&) noexcept = default;
MassInverse& MassInverse::operator=(MassInverse&&) noexcept = default;

Eigen::MatrixXd MassInverse::solve(const Eigen::MatrixXd& rhs,
                                   const Eigen::MatrixXd& slopes) const {
    return extension_ ? extension_->solve(rhs, slopes) : solveByFactors(rhs);
}

TransposedSolution MassInverse::solveTransposed(const Eigen::MatrixXd& rhs) const {
    return extension_ ? extension_->solveTransposed(rhs)
                      : TransposedSolution{solveByFactors(rhs), {}};
}

Eigen::MatrixXd MassInverse::solveByFactors(const Eigen::MatrixXd& rhs) const {
    const Eigen::MatrixXd reduced = rhs(active_, Eigen::all);
    Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(n_, rhs.cols());
    solution(active_, Eigen::all) = factorisation_->solve(reduced);
    return solution;
}

} // namespace tokay::mapper
