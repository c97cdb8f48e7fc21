// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/linearAlgebra/LinearSolver.hpp"

namespace tokay::structure {

/// Cholesky factorisation (CHOLMOD, supernodal) of a symmetric matrix.
class SparseCholesky : public LinearSolver {
  public:
    /// @param pattern  both triangles, sorted columns; values are not used
    /// @param fixed    unknowns left out
    /// @throws SolverError if CHOLMOD reports any trouble, memory included
    SparseCholesky(const SparseMatrix& pattern, const std::vector<bool>& fixed);
    SparseCholesky(SparseCholesky&&) noexcept;
    ~SparseCholesky() override;

    /// Takes the lower triangle.
    /// @throws NotPositiveDefinite; SolverError otherwise
    void factorise(const SparseMatrix& matrix) override;
    Eigen::MatrixXd solveAll(const Eigen::MatrixXd& rightHandSides) override;
    int nFree() const override;
    double nFactorEntries() const override;
    double bytes() const override;
    std::string name() const override { return "CHOLMOD"; }

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay::structure
