// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// A degenerate edge: the surface shrinks to one point, as at the pole of a sphere.
struct Pole {
    Edge edge;
    Point place;
    /// Unit normal; zero if the surface has no tangent plane there (a cone's tip).
    Point normal;
};

/// Degenerate edges of a surface.
std::vector<Pole> surfacePoles(const NurbsSurface& surface);

} // namespace tokay::geometry
