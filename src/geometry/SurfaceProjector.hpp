#pragma once

#include "geometry/BoxTree.hpp"
#include "geometry/NurbsSurface.hpp"

namespace tokay::geometry {

struct SurfaceProjection {
    double xi;
    double eta;
    /// Distance of the point to the surface [m].
    double distance;
    /// False if Newton's iteration ended without meeting its tolerance.
    bool converged;
    /// Another place of the surface is as near, to 1e-6 of the distance.
    bool ambiguous;
};

/// Closest points of a surface, as CurveProjector for curves; degenerate edges
/// (the pole of a sphere) and seams included.
class SurfaceProjector {
  public:
    explicit SurfaceProjector(const NurbsSurface& surface);

    SurfaceProjection closest(const Point& point) const;

  private:
    struct Piece {
        Eigen::Array2d from, to;
    };
    SurfaceProjection closestIn(const Piece& piece, const Point& point) const;

    NurbsSurface surface_;
    Point centre_;
    double size_;
    std::vector<Piece> pieces_;
    BoxTree tree_;
};

} // namespace tokay::geometry
