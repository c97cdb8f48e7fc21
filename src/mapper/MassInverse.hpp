#pragma once

#include "mapper/SparseMatrix.hpp"
#include <memory>

namespace tokay::mapper {

/// What to do with a mass matrix that does not determine all its values, as
/// that of a trimmed edge: the trace has fewer dimensions than there are functions.
enum class SingularMass { refuse, minimumNorm };

/// Solves with a symmetric positive semidefinite matrix, factored once:
/// Cholesky, or the pseudo-inverse by two sparse rank-revealing QRs if singular.
/// Rows that are zero stand for values that are not there and stay zero.
class MassInverse {
  public:
    /// @throws SolverError if the matrix is singular and this is to be refused
    MassInverse(const SparseMatrix& matrix, SingularMass singular);
    ~MassInverse();
    MassInverse(MassInverse&&) noexcept;
    MassInverse& operator=(MassInverse&&) noexcept;

    /// @param rhs  n x m
    /// @return     n x m; of least norm if the matrix is singular
    Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;

    /// Rows that are not zero.
    int nActive() const { return static_cast<int>(active_.size()); }
    int rank() const { return rank_; }
    /// Largest over smallest nonzero eigenvalue, estimated to a per cent by
    /// Lanczos iterations.
    double conditionOnRange() const { return condition_; }

  private:
    class Factorisation;
    class Cholesky;
    class PseudoInverse;

    double conditionWith(const Factorisation& factorisation) const;

    int n_;
    std::vector<int> active_;
    Eigen::SparseMatrix<double> reduced_;
    std::unique_ptr<Factorisation> factorisation_;
    int rank_;
    double condition_;
};

} // namespace tokay::mapper
