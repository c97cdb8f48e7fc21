// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/quadrature/Triangle.hpp"

#include <array>

namespace tokay::mapper {

/// The part of a triangle that another one covers, seen along the first one's normal: a convex
/// polygon with its corners in barycentric coordinates of the first one. Whichever way the other
/// one faces.
class TriangleOverlap {
  public:
    TriangleOverlap(const geometry::Triangle& below, const geometry::Triangle& above);

    int nCorners() const { return nCorners_; }
    const geometry::Barycentric& corner(int i) const { return corners_[i]; }
    /// Area, as a share of that of the triangle.
    double share() const { return share_; }
    /// The same of the triangle of corners 0, i and i + 1; their sum is the whole.
    double share(int i) const;
    /// Integral of the products of the barycentric coordinates over it, as a share of the area of
    /// the triangle.
    Eigen::Matrix3d moments() const;
    /// Mean of the corners.
    geometry::Barycentric middle() const;

  private:
    void clip(int side);
    double signedShare(int i) const;

    /// Three, and where rounding turns a side to and fro as many as are cut.
    std::array<geometry::Barycentric, 9> corners_;
    int nCorners_ = 3;
    double share_ = 0;
    bool isTurned_ = false;
};

} // namespace tokay::mapper
