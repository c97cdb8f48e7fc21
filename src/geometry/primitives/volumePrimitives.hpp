// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsVolume.hpp"

namespace tokay::geometry {

/// Exact and as coarse as can be, as the primitives of surfaces.

/// Box parallel to the axes; xi along x, eta along y, zeta along z.
/// @throws InputError if a size is not positive and finite
NurbsVolume block(const Point& origin, const Point& size);

/// Volume within half the thickness on either side of a middle surface; zeta
/// runs along the surface's normal, from back to front.
/// @throws InputError if the thickness is not positive, or the surface's parallels
///         are no NURBS with its own knots and weights (those of a plane, cylinder or
///         sphere are)
NurbsVolume thickened(const NurbsSurface& middle, double thickness);

} // namespace tokay::geometry
