#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace tokay::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// LU factorisation (UMFPACK) of a matrix without the rows and columns of fixed
/// unknowns, for matrices that are indefinite or not symmetric.
class SparseLu {
  public:
    /// @param fixed  unknowns left out
    explicit SparseLu(const std::vector<bool>& fixed);
    SparseLu(SparseLu&&) noexcept;
    ~SparseLu();

    /// @throws SolverError if the matrix is singular
    void factorise(const SparseMatrix& matrix);

    /// Solution for a right-hand side; fixed unknowns are zero in it.
    Eigen::VectorXd solve(const Eigen::VectorXd& rightHandSide) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay::structure
