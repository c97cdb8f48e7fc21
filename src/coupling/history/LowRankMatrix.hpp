// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// How large a matrix that grows from time step to time step may become.
struct RankOptions {
    int maxRank = 200;
    double rankLimit = 1e-6;

    static const SchemaOf<RankOptions>& schema() {
        static const SchemaOf<RankOptions> schema = {
            {"maxRank", &RankOptions::maxRank, "[2, inf)", "",
             "Maximum rank of the Jacobian; beyond it, compressed to half by singular values."},
            {"rankLimit", &RankOptions::rankLimit, "[0, 1)", "",
             "Singular values below this fraction of the largest are dropped on compression."}};
        return schema;
    }
};

/// A Bᵀ: a matrix of many rows and columns and of small rank, which grows by
/// appended terms and can be compressed to its largest singular values.
class LowRankMatrix {
  public:
    /// Rank of the representation; 0: the zero matrix.
    int rank() const { return static_cast<int>(A_.cols()); }

    /// Adds A Bᵀ; A and B have as many columns as the term has rank.
    void append(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

    /// Keeps the first columns of A and B, and their marks.
    /// @param rank  their number, at most rank()
    void truncate(int rank);

    /// Keeps at most maxRank singular values, and none below relativeLimit
    /// times the largest. The error in the 2-norm is the first that is left
    /// out.
    void compress(int maxRank, double relativeLimit);

    /// Bounds time and memory of a matrix that grows from step to step: once the
    /// rank exceeds maxRank, or twice the number of rows or columns, beyond which
    /// terms repeat each other, compresses it to half of maxRank.
    void limitRank(const RankOptions& options);

    void scale(double factor);

    /// A Bᵀ v; zero of nRows if the rank is 0.
    Eigen::VectorXd apply(const Eigen::VectorXd& v, Eigen::Index nRows) const;

    void save(StateWriter& state) const;
    /// Meaning of A's rows; those of B are always components of the interface.
    enum class Rows { ofInterface, ofStructure };
    /// @throws channel::PeerError if the state is damaged
    void restore(StateReader& state, Rows rows);

    const Eigen::MatrixXd& A() const { return A_; }
    const Eigen::MatrixXd& B() const { return B_; }

    /// Marks of the columns: where two matrices have the same one, their columns of A and B
    /// are the same.
    const std::vector<std::uint64_t>& columnMarks() const { return columnMarks_; }

  private:
    void markColumnsFrom(Eigen::Index first);

    Eigen::MatrixXd A_;
    Eigen::MatrixXd B_;
    std::vector<std::uint64_t> columnMarks_;
};

} // namespace tokay::coupling
