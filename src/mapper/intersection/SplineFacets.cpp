// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/SplineFacets.hpp"

#include "geometry/trimming/patchTriangles.hpp"

namespace tokay::mapper {

namespace {

/// False for a triangle that a corner of three trimming curves or a pole leaves
/// without area.
bool hasArea(const Points& points, const std::array<int, 3>& corners) {
    const geometry::Triangle triangle(points.row(corners[0]), points.row(corners[1]),
                                      points.row(corners[2]));
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
        longest = std::max(longest, (triangle.corner(i) - triangle.corner((i + 1) % 3)).norm());
    }
    return triangle.area() > 1e-12 * longest * longest;
}

} // namespace

SplineFacets splineFacets(const SurfaceInterface& splines, double chordTolerance) {
    Points vertices(0, 3);
    SurfaceMesh::Faces faces;
    std::vector<int> pieces;
    for (int piece = 0; piece < splines.nPieces(); ++piece) {
        const geometry::TrimmedPatch& patch = splines.piece(piece).patch;
        const double span = splines.box(piece).diagonal() / std::sqrt(patch.nElements());
        const geometry::PatchTriangles triangles = patchTriangles(patch, chordTolerance * span);
        const int first = static_cast<int>(vertices.rows());
        vertices.conservativeResize(first + triangles.points.rows(), 3);
        vertices.bottomRows(triangles.points.rows()) = triangles.points;
        for (const std::array<int, 3>& corners : triangles.triangles) {
            if (hasArea(triangles.points, corners)) {
                faces.push_back({first + corners[0], first + corners[1], first + corners[2]});
                pieces.push_back(piece);
            }
        }
    }
    return {SurfaceMesh(std::move(vertices), std::move(faces), ValuesAt::vertices),
            std::move(pieces)};
}

} // namespace tokay::mapper
