// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bezier/BezierPatch.hpp"
#include "geometry/projection/BoxTree.hpp"
#include "geometry/spline/NurbsSurface.hpp"

#include <functional>
#include <memory>
#include <optional>

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

    /// The closest place that is accepted by its parameters (one inside trimming
    /// loops); none if there is none nearer than the limit [m].
    using Acceptance = std::function<bool(const Eigen::Vector2d&)>;
    std::optional<SurfaceProjection> closest(const Point& point, const Acceptance& accepts,
                                             double limit) const;

  private:
    std::vector<BezierPatch> pieces_;
    Point centre_;
    double size_;
    std::unique_ptr<BoxTree> tree_;
};

} // namespace tokay::geometry
