// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/interface/SurfaceMesh.hpp"

#include <functional>

namespace tokay::mapper {

/// A quadrature point of the intersection of a mesh with trimmed patches.
struct IntersectionPoint {
    Point position; ///< on the patch [m]
    double weight;  ///< of the area of the patch [m^2]
    double gap;     ///< to the plane of the triangle [m]
    int triangle;
    geometry::Barycentric inTriangle;
    int piece;
    int element;       ///< as SurfaceInterface numbers them
    Functions onPatch; ///< of the patch, by the structure's numbers
};

/// Callbacks of the intersection, in this order for each triangle of the mesh.
struct IntersectionVisitor {
    std::function<void(const IntersectionPoint&)> point;
    /// @param coveredShare  of the triangle by patches, 0 to 1
    std::function<void(int triangle, double coveredShare)> endTriangle;
};

/// Intersects every triangle with the knot spans of every patch within reach:
/// the triangle's corners are projected into the parameter space and joined by
/// straight sides, the polygon clipped by the knot spans and the loops. Corners
/// beyond the edge of a surface are continued along its tangents; triangles over
/// a seam are laid over both ends; at a pole the corner becomes a side, and a
/// triangle with a pole inside is cut into three around it.
/// @param reach   gap up to which a patch counts [m]
/// @param degree  of the quadrature on the pieces
void intersect(const SurfaceMesh& mesh, const SurfaceInterface& splines, double reach, int degree,
               const IntersectionVisitor& visitor);

} // namespace tokay::mapper
