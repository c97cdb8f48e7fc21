// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/linearAlgebra/LinearSolver.hpp"

namespace tokay::structure {

/// LU factorisation (UMFPACK), for matrices that are indefinite or not symmetric.
class SparseLu : public LinearSolver {
  public:
    SparseLu(const SparseMatrix& pattern, const std::vector<bool>& fixed);
    SparseLu(SparseLu&&) noexcept;
    ~SparseLu() override;

    /// @throws SingularMatrix; SolverError if memory does not suffice
    void factorise(const SparseMatrix& matrix) override;
    Eigen::MatrixXd solveAll(const Eigen::MatrixXd& rightHandSides) override;
    int nFree() const override;
    double nFactorEntries() const override;
    double bytes() const override;
    std::string name() const override { return "UMFPACK"; }

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay::structure
