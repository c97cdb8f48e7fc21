// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/linearAlgebra/SparseLu.hpp"

namespace tokay::structure {

/// Solves for unknowns u = E q of which some depend on the free ones, q: the free rows of
/// (K E) q = b, by LU.
class ExtendedSolver : public LinearSolver {
  public:
    /// @param pattern    of K
    /// @param fixed      unknowns whose rows are left out, dependent ones included
    /// @param extension  E; is kept by reference
    ExtendedSolver(const SparseMatrix& pattern, const std::vector<bool>& fixed,
                   const SparseMatrix& extension)
        : extension_(extension), solver_(SparseMatrix(pattern * extension), fixed) {}

    void factorise(const SparseMatrix& matrix) override {
        solver_.factorise(SparseMatrix(matrix * extension_));
    }
    Eigen::MatrixXd solveAll(const Eigen::MatrixXd& rightHandSides) override {
        return extension_ * solver_.solveAll(rightHandSides);
    }
    int nFree() const override { return solver_.nFree(); }
    double nFactorEntries() const override { return solver_.nFactorEntries(); }
    double bytes() const override { return solver_.bytes(); }
    std::string name() const override { return solver_.name(); }

  private:
    const SparseMatrix& extension_;
    SparseLu solver_;
};

} // namespace tokay::structure
