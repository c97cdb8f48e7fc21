// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/SparseMatrix.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace tokay::structure {

/// A sum of weighted squares, linear in unknowns and data, that the dependent unknowns
/// minimise: the rows of its normal equations, A u = B data, are theirs.
class ExtensionFunctional {
  public:
    /// @param dependents  unknowns, ascending
    ExtensionFunctional(int nUnknowns, const std::vector<int>& dependents);

    /// Data that a square compares with: three numbers (a vector of space).
    int newData() { return nData_++; }

    /// Adds weight (row . u_c - datum_c)^2 for components of the nodes' displacement.
    /// @param row  a number for each node
    void add(const std::vector<int>& nodes, const std::array<bool, 3>& components,
             const Eigen::RowVectorXd& row, double weight, int data = -1);

    /// Adds |rows u|^2.
    /// @param rows  component c of node k is column 3 k + c
    void add(const std::vector<int>& nodes, const Eigen::MatrixXd& rows);
    /// Makes that |rows u - onData datum|^2, but for what does not depend on u.
    /// @param onData  as many rows, 3 columns
    void addData(const std::vector<int>& nodes, const Eigen::MatrixXd& rows,
                 const Eigen::MatrixXd& onData, int data);

    /// Adds weight (row . u_c - other . v_c)^2, v being the displacement of other nodes that
    /// the square is not differentiated by: that of the last iterate.
    void addLagged(const std::vector<int>& nodes, const std::array<bool, 3>& components,
                   const Eigen::RowVectorXd& row, const std::vector<int>& otherNodes,
                   const Eigen::RowVectorXd& other, double weight);

    /// Rows of the dependents, a column an unknown: what v adds.
    SparseMatrix laggedMatrix() const;
    /// Rows of the dependents, a column an unknown.
    SparseMatrix matrix() const;
    /// Rows of the dependents, three columns for each newData().
    SparseMatrix dataMatrix() const;

  private:
    SparseMatrix sumOf(const std::vector<Eigen::Triplet<double>>& entries, int nColumns) const;

    int nUnknowns_;
    int nDependents_;
    std::vector<int> rowOf_; ///< of each unknown; -1: none
    int nData_ = 0;
    std::vector<Eigen::Triplet<double>> matrix_, laggedMatrix_, dataMatrix_;
};

} // namespace tokay::structure
