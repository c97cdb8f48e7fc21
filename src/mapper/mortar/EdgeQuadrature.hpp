// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/interface/CurveInterface.hpp"

#include <vector>

namespace tokay::mapper {

/// Gauss points along the edge of a structure that integrate products of its functions and
/// those of the edge that it meets exactly, with the functions that do not vanish there.
///
/// Values at these points are all that the other side needs to give and to take: a mortar
/// mapping between the two sides is a sum over them.
class EdgeQuadrature {
  public:
    /// @param from   the edge that is met
    /// @param to     the edge whose functions are tabulated
    /// @throws InputError if the two edges do not lie on each other, one way or the other:
    ///         the largest gap, and where
    EdgeQuadrature(const CurveInterface& from, const CurveInterface& to, const GapLimit& gapLimit);

    int nPoints() const { return static_cast<int>(points_.rows()); }
    const Points& points() const { return points_; }            ///< nPoints x 3 [m]
    const Eigen::VectorXd& weights() const { return weights_; } ///< [m]

    /// Numbers of the functions that do not vanish on the edge, ascending.
    const std::vector<int>& functions() const { return functions_; }
    /// Their values, nPoints x functions.
    const Eigen::MatrixXd& values() const { return values_; }

    /// M_DD: integral of N N^T over the edge, functions x functions [m].
    Eigen::MatrixXd massMatrix() const;

    /// Largest distance between the two edges [m].
    double largestGap() const { return largestGap_; }

  private:
    Points points_;
    Eigen::VectorXd weights_;
    std::vector<int> functions_;
    Eigen::MatrixXd values_;
    double largestGap_;
};

} // namespace tokay::mapper
