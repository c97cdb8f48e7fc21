// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace tokay::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Sparsity of a symmetric matrix with nComponents unknowns a node, given which
/// nodes have to do with each other.
class NodePattern {
  public:
    /// @param neighbours  of each node; any order, repetitions allowed, its own left
    ///                    out or not; must be mutual
    /// @throws InputError if the matrix has more than 2^31 entries
    NodePattern(int nComponents, std::vector<std::vector<int>> neighbours);

    /// The matrix with all its entries, which are zero.
    SparseMatrix zeroMatrix() const;

    /// Adds an element matrix; fast where the nodes' numbers follow each other.
    /// @param nodes    neighbours of each other
    /// @param element  component c of nodes[k] is number nComponents k + c
    /// @param values   of a matrix made by zeroMatrix
    void add(const std::vector<int>& nodes, const Eigen::MatrixXd& element, double* values) const;

  private:
    void findPlaces(int column, const std::vector<int>& nodes, std::vector<int>& places) const;

    int nComponents_;
    std::vector<int> neighbours_;
    std::vector<std::ptrdiff_t> starts_; ///< in neighbours_, of each node
};

} // namespace tokay::structure
