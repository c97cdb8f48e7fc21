// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// Which columns of a least-squares problem count as dependent, newest first.
enum class QrFilter {
    qr1, ///< diagonal entry of R below filterLimit x norm of R
    qr2  ///< part orthogonal to the newer columns below filterLimit x column
};

struct FilterOptions {
    QrFilter filter = QrFilter::qr2;
    double filterLimit = 0.01;

    static const SchemaOf<FilterOptions>& schema();
};

/// QR factors of a few columns, newest first, updated as columns come and go:
/// the least-squares core of the quasi-Newton methods. Columns that depend on
/// newer ones, and columns of zeros, are dropped, never divided by.
class FilteredQr {
  public:
    explicit FilteredQr(const FilterOptions& options) : options_(options) {}

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

    FilterOptions options_;
    std::vector<Eigen::VectorXd> q_;
    Eigen::MatrixXd r_;
};

} // namespace tokay::coupling
