#pragma once

#include "geometry/BezierPatch.hpp"
#include "geometry/BoxTree.hpp"
#include "geometry/NurbsSurface.hpp"
#include <memory>

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
    std::vector<BezierPatch> pieces_;
    Point centre_;
    double size_;
    std::unique_ptr<BoxTree> tree_;
};

} // namespace tokay::geometry
