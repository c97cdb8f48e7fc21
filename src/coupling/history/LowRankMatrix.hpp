// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// A Bᵀ: a matrix of many rows and columns and of small rank, which grows by
/// appended terms and can be compressed to its largest singular values.
class LowRankMatrix {
  public:
    /// Rank of the representation; 0: the zero matrix.
    int rank() const { return static_cast<int>(A_.cols()); }

    /// Adds A Bᵀ; A and B have as many columns as the term has rank.
    void append(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

    /// Keeps at most largestRank singular values, and none below relativeLimit
    /// times the largest. The error in the 2-norm is the first that is left
    /// out.
    void compress(int largestRank, double relativeLimit);

    /// Bounds time and memory of a matrix that grows from step to step: once the
    /// rank exceeds largestRank, or twice the number of rows or columns, beyond which
    /// terms repeat each other, compresses it to half of largestRank.
    void limitRank(int largestRank, double relativeLimit);

    void scale(double factor) { A_ *= factor; }

    /// A Bᵀ v; zero of nRows if the rank is 0.
    Eigen::VectorXd apply(const Eigen::VectorXd& v, Eigen::Index nRows) const;

    void save(StateWriter& state) const;
    /// Meaning of A's rows; those of B are always components of the interface.
    enum class Rows { ofInterface, ofStructure };
    /// @throws channel::PeerError if the state is damaged
    void restore(StateReader& state, Rows rows);

    const Eigen::MatrixXd& A() const { return A_; }
    const Eigen::MatrixXd& B() const { return B_; }

  private:
    Eigen::MatrixXd A_;
    Eigen::MatrixXd B_;
};

} // namespace tokay::coupling
