// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/SparseMatrix.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::structure {

enum class Triangles { lower, both };

/// The rows and columns of a matrix that belong to free unknowns, as compressed
/// columns, with the unknowns scaled so that diagonal entries are one: functions
/// of which trimming has left a sliver are as good as others then.
class FreePart {
  public:
    /// @param pattern  both triangles, sorted columns; values are not used
    /// @param fixed    unknowns left out
    /// @throws SolverError if that is every one
    FreePart(const SparseMatrix& pattern, const std::vector<bool>& fixed, Triangles triangles);

    int size() const { return static_cast<int>(unknowns_.size()); }
    std::size_t nEntries() const { return rows_.size(); }
    const std::vector<int>& starts() const { return starts_; }
    const std::vector<int>& rows() const { return rows_; }
    /// In the whole matrix, of a free one.
    int unknown(int number) const { return unknowns_[number]; }

    /// Scaled values of the entries.
    /// @param matrix  of the pattern's sparsity; the scales are taken from its diagonal
    void setScaled(const SparseMatrix& matrix, double* values);

    /// Scaled right-hand side of the free unknowns.
    void reduce(const Eigen::Ref<const Eigen::VectorXd>& whole, double* reduced) const;
    /// Solution of all unknowns from the scaled one; fixed ones are zero.
    Eigen::VectorXd extend(const double* reduced) const;

    /// [bytes]
    double bytes() const;

  private:
    Eigen::Index nWhole_;
    std::vector<int> unknowns_;
    std::vector<int> starts_, rows_;
    std::vector<int> slots_;         ///< in the whole matrix, of each entry
    std::vector<int> diagonalSlots_; ///< of each free unknown
    std::vector<double> scales_;
};

} // namespace tokay::structure
