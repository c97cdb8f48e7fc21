// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/KnotVector.hpp"
#include "geometry/spline/Points.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// Nodes of a tensor-product patch: its control points, where those of opposite sides
/// that coincide are one node. So a body that is closed in itself (a ring, a pipe) is
/// joined along its seam, with a continuous displacement; without that it would open
/// there like a slit.
class PatchNodes {
  public:
    /// @param directions  the first one is numbered fastest
    /// @param weights     empty: all 1
    /// @param isSlit      true: sides that coincide stay apart
    PatchNodes(const std::vector<geometry::KnotVector>& directions,
               const geometry::Points& controlPoints, const Eigen::VectorXd& weights, bool isSlit);

    int count() const { return static_cast<int>(firstControlPoints_.size()); }
    int nControlPoints() const { return static_cast<int>(ofControlPoints_.size()); }

    /// Node of a control point, and nodes of several.
    int of(int controlPoint) const { return ofControlPoints_[controlPoint]; }
    std::vector<int> of(const std::vector<int>& controlPoints) const;

    /// First control point of each node.
    const std::vector<int>& firstControlPoints() const { return firstControlPoints_; }

    /// Directions along which the patch is closed, ascending.
    const std::vector<int>& closedDirections() const { return closedDirections_; }

    /// For the log: ", closed along xi", or empty.
    std::string description() const;

    /// Functions that may share an element with each node.
    std::vector<std::vector<int>>
    neighbours(const std::vector<geometry::KnotVector>& directions) const;

    /// Values of the control points from those of the nodes.
    /// @param values  nComponents per node
    Eigen::VectorXd toControlPoints(const Eigen::VectorXd& values) const;

    /// The transpose of toControlPoints(): sums.
    /// @param values  nComponents per control point
    Eigen::VectorXd toNodes(const Eigen::VectorXd& values) const;

    /// Supports of nodes: fixed if a control point is.
    /// @param fixed  nComponents per control point
    std::vector<bool> fixed(const std::vector<bool>& fixed) const;

  private:
    std::vector<int> ofControlPoints_;
    std::vector<int> firstControlPoints_;
    std::vector<int> closedDirections_;
};

} // namespace tokay::structure
