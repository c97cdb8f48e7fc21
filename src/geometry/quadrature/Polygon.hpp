// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tokay::geometry {

/// Corners in order; closed by the side from the last to the first.
using Polygon = std::vector<Eigen::Vector2d>;

/// Positive if counter-clockwise.
double signedArea(const Polygon& polygon);

/// The part where normal . x <= offset. A polygon that is not convex may come
/// back with sides that run to and fro on the cutting line: they cancel in every
/// integral by signed triangles.
/// Source: Sutherland & Hodgman, Commun. ACM 17, 1974
Polygon clippedByHalfPlane(const Polygon& polygon, const Eigen::Vector2d& normal, double offset);

/// The part inside a convex, counter-clockwise polygon.
Polygon clippedByConvex(const Polygon& polygon, const Polygon& convex);

/// The part inside a rectangle.
Polygon clippedByRectangle(const Polygon& polygon, const Eigen::Vector2d& lower,
                           const Eigen::Vector2d& upper);

} // namespace tokay::geometry
