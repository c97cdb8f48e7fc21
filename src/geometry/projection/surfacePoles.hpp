// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// A degenerate edge: the surface shrinks to one point, as at the pole of a sphere.
struct Pole {
    Edge edge;
    Point place;
    /// Of unit length; zero if the surface has no tangent plane there (a cone's tip).
    Point normal;
};

/// All of a surface's degenerate edges.
std::vector<Pole> surfacePoles(const NurbsSurface& surface);

} // namespace tokay::geometry
