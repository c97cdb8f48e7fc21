// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"
#include "mapper/interface/CurveInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tokay::mapper {

/// Faces on which the other side's forces act: edges of a plane scene, polygons in space.
struct FaceMesh {
    Points vertices; ///< n x 3 [m]
    /// Vertices of each face, in order around it; a face of one vertex is a point.
    std::vector<std::vector<int>> faces;

    int nFaces() const { return static_cast<int>(faces.size()); }
    bool hasOnlyPoints() const {
        return std::all_of(faces.begin(), faces.end(),
                           [](const std::vector<int>& face) { return face.size() == 1; });
    }
};

/// Places at which the forces of faces act. The shares of a face sum to 1, and their
/// mean place is the centroid of the face: force and moment are kept.
struct LoadPoints {
    Points points;          ///< nPoints x 3 [m]
    RowSparseMatrix shares; ///< nPoints x nFaces

    /// @param onFaces  nFaces x 3 [N]
    /// @return         nPoints x 3 [N]
    Points onPoints(const Points& onFaces) const { return shares * onFaces; }
};

/// The vertices of the faces, each with the integral of its function over the face:
/// equal shares on an edge, a triangle and a parallelogram.
LoadPoints loadsAtVertices(const FaceMesh& mesh);

/// Quadrature points on the pieces into which the knot spans cut the edges, so that the
/// load of an edge, a constant traction, is integrated with the functions of the curves
/// whichever side is the finer one. An edge is cut where the plane across the curve at a
/// knot meets it.
LoadPoints integratedLoads(const CurveInterface& splines, const FaceMesh& mesh);

/// The same for faces in space, cut by knot spans and loops of the patches. The weights
/// on a triangle of a face are corrected by the linear function that restores its area
/// and centroid, which straight sides in parameter space change. A triangle that patches
/// cover in part (the end face of a thin body) is divided evenly instead, about twice in
/// each knot span. Where no face is larger than half a span the quadrature has degree 2.
/// @param reach  gap up to which a patch counts [m]
/// @throws InputError for a face without area
LoadPoints integratedLoads(const SurfaceInterface& splines, const FaceMesh& mesh, double reach);

} // namespace tokay::mapper
