// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/KnotVector.hpp"
#include "igaStructure/assembly/SparseMatrix.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::structure {

/// Functions of a tensor product that may share an element with each function: those
/// whose indices differ by no more than the degree along each direction.
/// @param directions  the first one is numbered fastest
std::vector<std::vector<int>> tensorNeighbours(const std::vector<geometry::KnotVector>& directions);

/// Sparsity of a symmetric matrix with nComponents unknowns per node, given which
/// nodes share an element.
class NodePattern {
  public:
    /// @param neighbours  of each node; any order, repetitions allowed, its own left
    ///                    out or not; must be mutual
    /// @throws InputError if the matrix has more than 2^31 entries
    NodePattern(int nComponents, std::vector<std::vector<int>> neighbours);

    /// The matrix with all its entries, which are zero.
    SparseMatrix zeroMatrix() const;

    /// Adds an element matrix; fast where the nodes' indices are consecutive.
    /// @param nodes    neighbours of each other
    /// @param element  component c of nodes[k] has index nComponents k + c
    /// @param values   of a matrix made by zeroMatrix
    void add(const std::vector<int>& nodes, const Eigen::MatrixXd& element, double* values) const;

  private:
    void findRows(int column, const std::vector<int>& nodes, std::vector<int>& rows) const;

    int nComponents_;
    std::vector<int> neighbours_;
    std::vector<std::ptrdiff_t> starts_; ///< in neighbours_, of each node
};

} // namespace tokay::structure
