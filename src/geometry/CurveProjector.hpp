#pragma once

#include "geometry/BoxTree.hpp"
#include "geometry/NurbsCurve.hpp"

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
/// All tolerances are relative to the size of the curve.
class CurveProjector {
  public:
    explicit CurveProjector(const NurbsCurve& curve);

    CurveProjection closest(const Point& point) const;

  private:
    struct Piece {
        double from, to;
    };
    CurveProjection closestIn(const Piece& piece, const Point& point) const;

    /// Copy, moved to its centre: far from the origin no digits are lost.
    NurbsCurve curve_;
    Point centre_;
    double size_;
    std::vector<Piece> pieces_;
    BoxTree tree_;
};

} // namespace tokay::geometry
