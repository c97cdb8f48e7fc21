// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace tokay::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Sparsity of a tensor-product patch with two unknowns a control point.
///
/// The neighbours of control point (i, j) are a box of control points, so the
/// place of each entry in the compressed matrix is known without a search.
/// Unknown 2 k + c is component c of control point k = i + nU j.
class TensorPattern {
  public:
    TensorPattern(int nU, int nV, int degreeU, int degreeV);

    /// The matrix with all its entries, which are zero.
    SparseMatrix zeroMatrix() const;

    /// Adds an element matrix.
    /// @param firstU, firstV  control point of the element's first function
    /// @param element  unknowns of (degreeU + 1)(degreeV + 1) control points, U fastest
    /// @param values   of a matrix made by zeroMatrix
    void add(int firstU, int firstV, const Eigen::MatrixXd& element, double* values) const;

  private:
    int nU_, nV_, degreeU_, degreeV_;
    // First entry of the first column of each control point.
    Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 1> starts_;
};

} // namespace tokay::structure
