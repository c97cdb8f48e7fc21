// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// A surface of a single knot span, for many evaluations: no memory is allocated.
class BezierPatch {
  public:
    /// @param piece  of one knot span, as bezierPieces gives them
    explicit BezierPatch(const NurbsSurface& piece);

    const Eigen::Vector2d& lower() const { return lower_; }
    const Eigen::Vector2d& upper() const { return upper_; }

    /// Rows as in NurbsSurface::derivatives, order 2.
    using Derivatives = Eigen::Matrix<double, 6, 3, Eigen::RowMajor>;
    Derivatives derivatives(const Eigen::Vector2d& parameters) const;

    /// Parameters that the control point nearest to the point would have if the
    /// patch were evenly parametrised.
    Eigen::Vector2d guess(const Point& point) const;

  private:
    int degreeU_, degreeV_;
    Eigen::Vector2d lower_, upper_;
    bool isRational_;
    Points points_;
    /// Rows (w x, w y, w z, w); w is 1 if the patch is polynomial.
    Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> homogeneous_;
};

} // namespace tokay::geometry
