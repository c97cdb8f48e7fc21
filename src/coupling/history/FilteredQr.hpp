// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CouplingOptions.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// QR factors of a few columns, newest first, updated as columns come and go:
/// the least-squares core of the quasi-Newton methods. Columns that depend on
/// newer ones, and columns of zeros, are dropped, never divided by.
class FilteredQr {
  public:
    FilteredQr(QrFilter filter, double limit) : filter_(filter), limit_(limit) {}

    int nColumns() const { return static_cast<int>(q_.size()); }

    /// Puts the column before all others, then drops dependent ones.
    /// @return  numbers of the dropped columns, to be erased one after the
    ///          other by whoever keeps data beside them
    std::vector<int> prepend(const Eigen::VectorXd& column);

    void remove(int column);
    void clear();

    void save(StateWriter& state) const;
    /// Its columns are interface vectors.
    void restore(StateReader& state);

    /// Coefficients c that minimise |V c - rightHandSide|.
    Eigen::VectorXd solve(const Eigen::VectorXd& rightHandSide) const;

    /// Orthonormal basis of the columns, one vector a column.
    const std::vector<Eigen::VectorXd>& q() const { return q_; }

    /// Upper triangular, nColumns x nColumns.
    const Eigen::MatrixXd& r() const { return r_; }

  private:
    void rotate(int row, int column);
    bool isDependent(int column) const;

    QrFilter filter_;
    double limit_;
    std::vector<Eigen::VectorXd> q_;
    Eigen::MatrixXd r_;
};

} // namespace tokay::coupling
