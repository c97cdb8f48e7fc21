// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"
#include "mapper/mortar/MassInverse.hpp"

#include <Eigen/SPQRSupport>
#include <Eigen/UmfPackSupport>

#include <vector>

namespace tokay::mapper {

/// Solves M x = b with a singular M, and of all solutions takes the one with the
/// least x^T G x - 2 x^T h: the trace fixes what it can, the gradient term the others. This is
/// the limit of small epsilon of EGM's functional
///   1/2 int_edge (u - uBar)^2 + epsilon/2 int_whole cut elements (du/dn - g)^2,
/// so the trace is the one of any other choice. g is the slope of the source across the edge,
/// where it knows one (the edge of a patch): then fields that are linear across the edge
/// are exact in all of the cut elements. Of a source that is known on the edge only g is 0: fields
/// that do not change across the edge are exact, and of others the slope times the size of the
/// elements is missing; the minimum norm's error does not fall with the size at all
/// (testGradientTerm.cpp). (Jumps of derivatives across the faces of elements cannot take the
/// term's place: a field linear across the edge and zero on it has none.)
class GradientExtension {
  public:
    /// @param mass, gradient  symmetric, of one size
    /// @throws SolverError if the two together do not determine all values
    GradientExtension(const RowSparseMatrix& mass, const RowSparseMatrix& gradient);

    /// @param rhs     b: n x m, in the range of M
    /// @param slopes  h: n x m
    Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs, const Eigen::MatrixXd& slopes) const;
    /// By transposes: the part for b, and that for h.
    TransposedSolution solveTransposed(const Eigen::MatrixXd& rhs) const;

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
    double scale_; ///< of G in the matrix below
    /// [G, (R P^T)^T; R P^T, 0]
    ColumnMatrix saddle_;
    Eigen::UmfPackLU<ColumnMatrix> factors_; ///< of it; refers to it
};

} // namespace tokay::mapper
