#pragma once

#include "common/errors.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The matrix is not positive definite.
class NotPositiveDefinite : public SolverError {
  public:
    NotPositiveDefinite(int theUnknown, const std::string& message)
        : SolverError(message), unknown(theUnknown) {}
    int unknown; ///< where the first pivot that is not positive was met
};

/// Cholesky factorisation (CHOLMOD, supernodal) of a symmetric matrix without
/// the rows and columns of fixed unknowns. Analysed once for its sparsity,
/// factored for new values as often as needed, kept for many solutions. Unknowns
/// are scaled by the diagonal, so their units and sizes do not matter.
class SparseCholesky {
  public:
    /// @param pattern  both triangles, sorted columns; values are not used
    /// @param fixed    unknowns left out
    /// @throws SolverError if CHOLMOD reports any trouble, memory included
    SparseCholesky(const SparseMatrix& pattern, const std::vector<bool>& fixed);
    SparseCholesky(SparseCholesky&&) noexcept;
    ~SparseCholesky();

    /// @param matrix  with the sparsity given at construction
    /// @throws NotPositiveDefinite; SolverError otherwise
    void factorise(const SparseMatrix& matrix);

    /// Solution for a right-hand side; fixed unknowns are zero in it.
    /// Needs a factorisation.
    Eigen::VectorXd solve(const Eigen::VectorXd& rightHandSide);

    int nFree() const;
    /// Entries of the factor.
    double nFactorEntries() const;
    /// Memory of the factor and of its matrix [bytes].
    double bytes() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Path of the library that does the dense products: OpenBLAS or a slower one.
std::string blasLibrary();

} // namespace tokay::structure
