// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/BoxTree.hpp"
#include "geometry/spline/NurbsCurve.hpp"

#include <memory>

namespace tokay::geometry {

struct CurveProjection {
    double xi;
    /// Distance of the point to the curve [m].
    double distance;
    /// False if Newton's iteration ended without meeting its tolerance.
    bool converged;
    /// Another place of the curve is as near, to 1e-6 of the distance.
    bool ambiguous;
};

/// Closest points of a curve, by a tree over the boxes of its Bezier pieces
/// and a safeguarded Newton iteration in each piece that can hold the closest
/// point. So ends, C0 knots, and points near the evolute are found reliably.
/// Closest points of a curve; tolerances are relative to its size.
class CurveProjector {
  public:
    explicit CurveProjector(const NurbsCurve& curve);

    CurveProjection closest(const Point& point) const;

  private:
    /// Bezier pieces, nearly flat, moved to the centre: so one-sided derivatives
    /// are right at C0 knots, and far from the origin no digits are lost.
    std::vector<NurbsCurve> pieces_;
    Point centre_;
    double size_;
    std::unique_ptr<BoxTree> tree_;
};

} // namespace tokay::geometry
