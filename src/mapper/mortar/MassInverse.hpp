// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"

#include <memory>

namespace tokay::mapper {

/// Treatment of a mass matrix that does not determine all its values, as
/// that of a trimmed edge: the trace has fewer dimensions than there are functions.
enum class SingularMass {
    refuse,
    minimumNorm, ///< least sum of squares of the values
    gradientTerm ///< least change across the edge, see GradientExtension
};

class GradientExtension;

/// Solution by the transpose of a solve that takes two right-hand sides, n x m each.
struct TransposedSolution {
    Eigen::MatrixXd trace;
    Eigen::MatrixXd slopes; ///< empty if there is no gradient term
};

/// Solves with a symmetric positive semidefinite matrix, factored once:
/// Cholesky, or the pseudo-inverse by two sparse rank-revealing QRs if singular.
/// Rows that are zero stand for values that are not there and stay zero.
class MassInverse {
  public:
    /// @param gradientTerm  of the same size, for the choice of that name
    /// @throws SolverError if the matrix is singular and this is to be refused, or
    /// the gradient term leaves values open
    MassInverse(const RowSparseMatrix& matrix, SingularMass singular,
                const RowSparseMatrix& gradientTerm = {});
    ~MassInverse();
    MassInverse(MassInverse&&) noexcept;
    MassInverse& operator=(MassInverse&&) noexcept;

    /// @param rhs     n x m
    /// @param slopes  n x m, for the gradient term (GradientExtension); not used without it
    /// @return        n x m; the chosen one of all solutions if the matrix is singular
    Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs, const Eigen::MatrixXd& slopes = {}) const;
    /// The choice makes the inverse of a singular matrix unsymmetric.
    TransposedSolution solveTransposed(const Eigen::MatrixXd& rhs) const;

    /// Rows that are not zero.
    int nActive() const { return static_cast<int>(active_.size()); }
    int rank() const { return rank_; }
    bool isSingular() const { return rank_ < nActive(); }
    /// Largest over smallest nonzero eigenvalue, estimated to a per cent by
    /// Lanczos iterations.
    double conditionOnRange() const { return condition_; }

  private:
    class Factorisation;
    class Cholesky;
    class PseudoInverse;

    Eigen::MatrixXd solveByFactors(const Eigen::MatrixXd& rhs) const;

    int n_;
    std::vector<int> active_;
    std::unique_ptr<Factorisation> factorisation_;
    std::unique_ptr<GradientExtension> extension_;
    int rank_;
    double condition_;
};

} // namespace tokay::mapper
