// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace tokay::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Sparsity of a line: the functions of each element are degree + 1 that follow
/// each other.
class LinePattern {
  public:
    /// @param dimension       unknowns a control point
    /// @param firstFunctions  of each element
    LinePattern(int dimension, int nControlPoints, int degree, std::vector<int> firstFunctions);

    /// The matrix with all its entries, which are zero.
    SparseMatrix zeroMatrix() const { return zero_; }

    /// Adds an element matrix of dimension (degree + 1) unknowns.
    void add(int element, const Eigen::MatrixXd& matrix, SparseMatrix& sum) const;

  private:
    int dimension_;
    std::vector<int> firstFunctions_;
    SparseMatrix zero_;
};

} // namespace tokay::structure
