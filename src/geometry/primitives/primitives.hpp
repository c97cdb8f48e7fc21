// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// Primitives are exact and as coarse as can be; `refine` makes them fine.
/// Lengths in m, angles in rad. A size that is not positive and finite is an
/// InputError that names it.

/// Straight line, degree 1, xi from 0 to 1.
NurbsCurve line(const Point& start, const Point& end);

/// Circular arc in a plane z = const, counter-clockwise from startAngle to
/// endAngle (at most a full turn), degree 2, rational, a span each quarter turn.
NurbsCurve arc(const Point& centre, double radius, double startAngle, double endAngle);

/// Rectangle parallel to the axes in the plane z = origin.z; xi along x, eta
/// along y, so that left, right, bottom, top are where one sees them.
NurbsSurface rectangle(const Point& origin, double sizeX, double sizeY);

/// Flat plate (parallelogram) in space: origin + xi edgeU + eta edgeV.
NurbsSurface plate(const Point& origin, const Point& edgeU, const Point& edgeV);

/// Sector of a ring in a plane z = const: xi runs along the radius from inner
/// (left) to outer (right), eta along the angle (bottom: startAngle, top: endAngle).
NurbsSurface ringSector(const Point& centre, double innerRadius, double outerRadius,
                        double startAngle, double endAngle);

/// Patch of a cylinder around the z axis through base: xi runs along the angle,
/// eta along z from base.z over the height. The normal points outwards.
NurbsSurface cylinderPatch(const Point& base, double radius, double height, double startAngle,
                           double endAngle);

/// Full sphere: xi runs around the z axis from the x axis on (the seam), eta
/// from the south pole to the north pole. The normal points outwards.
NurbsSurface sphere(const Point& centre, double radius);

} // namespace tokay::geometry
