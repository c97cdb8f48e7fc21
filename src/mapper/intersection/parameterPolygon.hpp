// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/SurfaceProjector.hpp"
#include "geometry/quadrature/Polygon.hpp"

#include <array>

namespace tokay::mapper {

/// A corner of a mesh in the parameter space of a surface.
struct ProjectedCorner {
    Eigen::Vector2d at;
    /// Distance from the surface or its tangential continuation [m].
    double gap;
    bool converged;
    /// The parameter along a degenerate edge (pole) means nothing.
    std::array<bool, 2> isFree;
};

/// The projection of a point; one that falls onto an edge of the surface from
/// outside is continued along the tangents there.
ProjectedCorner projectedCorner(const geometry::NurbsSurface& surface,
                                const geometry::SurfaceProjector& projector,
                                std::array<bool, 2> isClosed, const geometry::Point& point);

/// The image of a triangle in parameter space, counter-clockwise. Corners beyond
/// a seam are moved by a period next to the others; a corner at a pole becomes a
/// side between the parameters of its neighbours.
geometry::Polygon parameterPolygon(const geometry::NurbsSurface& surface,
                                   std::array<bool, 2> isClosed,
                                   const std::array<ProjectedCorner, 3>& corners);

} // namespace tokay::mapper
