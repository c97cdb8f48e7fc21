// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/NodeUnion.hpp"
#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"

#include <Eigen/Core>

#include <array>

namespace tokay::structure {

/// True if the fourth derivative along an axis (0: xi, 1: eta) is in the knots: in jumps of the
/// third one, at degree 3.
bool hasFourthDerivativeInKnots(const geometry::NurbsSurface& surface, int axis);

/// Elements before and after an element along an axis; -1: none, or one that is trimmed away.
std::array<int, 2> neighboursAlong(const geometry::TrimmedPatch& patch, int element, int axis);

/// The face between two elements that are next to each other along an axis.
class FaceJump {
  public:
    /// @param pair  of elements, as they follow each other; the patch is borrowed
    FaceJump(const ShellPatch& patch, int axis, const std::array<int, 2>& pair);

    /// Distance between the middles of both elements, in parameters.
    double size() const { return size_; }

    /// True if all derivatives but that of the degree are continuous.
    bool isSmooth() const;

    /// Adds a factor times the jump of a derivative along the axis, at the face's end of the
    /// line through a place along the axis.
    /// @param order  of the derivative
    /// @param row    a number a node; grows with the nodes
    void add(const geometry::Parameters& place, int order, double factor, NodeUnion& nodes,
             Eigen::RowVectorXd& row) const;

  private:
    const ShellPatch& patch_;
    int axis_;
    std::array<int, 2> pair_;
    double knot_, size_;
};

} // namespace tokay::structure
