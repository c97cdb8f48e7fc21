// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"

#include <Eigen/SPQRSupport>
#include <Eigen/SparseLU>

#include <vector>

namespace tokay::mapper {

/// Solves M x = b with a singular M, and of all solutions takes the one with the
/// least x^T G x: the trace fixes what it can, the gradient term G the others. This is the
/// limit of small epsilon of EGM's functional
///   1/2 int_edge (u - uBar)^2 + epsilon/2 int_whole cut elements (du/dn)^2,
/// so the trace is the one of any other choice, and fields that do not change across the
/// edge are exact in all of the cut elements. A slope across the edge is not in the trace:
/// it comes out as 0 there, an error in the cut elements of the slope times their size; the
/// minimum norm's does not fall with the size at all (testGradientTerm.cpp). (Jumps of derivatives
/// across the faces of elements cannot take the term's place: a field linear across the edge and
/// zero on it has none.)
class GradientExtension {
  public:
    /// @param mass, gradient  symmetric, of one size
    /// @throws SolverError if the two together do not determine all values
    GradientExtension(const RowSparseMatrix& mass, const RowSparseMatrix& gradient);

    /// @param rhs  n x m, in the range of M
    Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;
    Eigen::MatrixXd solveTransposed(const Eigen::MatrixXd& rhs) const;

  private:
    using ColumnMatrix = Eigen::SparseMatrix<double>;

    /// Determined part of the trace, rank_ x active values.
    ColumnMatrix traceRows() const;

    Eigen::Index n_;
    /// Values that the mass or the gradient term reaches.
    std::vector<int> active_;
    /// M P = Q R, the trace: the first rank_ rows.
    Eigen::SPQR<ColumnMatrix> trace_;
    Eigen::Index rank_;
    /// [G, (R P^T)^T; R P^T, 0]
    Eigen::SparseLU<ColumnMatrix> saddle_;
};

} // namespace tokay::mapper
