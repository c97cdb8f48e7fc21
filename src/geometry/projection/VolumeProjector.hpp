// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/SurfaceProjector.hpp"
#include "geometry/spline/NurbsVolume.hpp"

namespace tokay::geometry {

struct VolumeProjection {
    Eigen::Vector3d parameters;
    /// Distance of the point to the volume; 0 inside, to rounding [m].
    double distance;
};

/// Closest points of a volume: where a point lies inside it, or the closest
/// place of its sides.
class VolumeProjector {
  public:
    explicit VolumeProjector(NurbsVolume volume);

    VolumeProjection closest(const Point& point) const;

  private:
    VolumeProjection closestOnSides(const Point& point) const;
    VolumeProjection inside(const Point& point) const;

    NurbsVolume volume_;
    double size_;
    std::vector<SurfaceProjector> sides_;
    std::vector<Eigen::Vector3d> samples_; ///< parameters of the elements' centres
    Points samplePoints_;
};

} // namespace tokay::geometry
