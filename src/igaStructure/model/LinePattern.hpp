#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace tokay::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Sparsity of a line with two unknowns a control point: the functions of each
/// element are degree + 1 that follow each other.
class LinePattern {
  public:
    /// @param firstFunctions  of each element
    LinePattern(int nControlPoints, int degree, std::vector<int> firstFunctions);

    /// The matrix with all its entries, which are zero.
    SparseMatrix zeroMatrix() const { return zero_; }

    /// Adds an element matrix of 2 (degree + 1) unknowns.
    void add(int element, const Eigen::MatrixXd& matrix, SparseMatrix& sum) const;

  private:
    std::vector<int> firstFunctions_;
    SparseMatrix zero_;
};

} // namespace tokay::structure
