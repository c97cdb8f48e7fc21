// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/polePartition.hpp"

#include <algorithm>
#include <optional>

namespace tokay::mapper {

using geometry::Barycentric;
using geometry::Pole;
using geometry::Triangle;

namespace {

/// A pole this near to a side or corner, in barycentric coordinates, lies on it.
constexpr double onSide = 1e-7;

/// Where the pole's normal pierces the triangle, if it does and the pole is what
/// the surface has nearest to there (not the far side of a sphere).
std::optional<Barycentric> piercing(const SurfaceInterface& splines, int piece, const Pole& pole,
                                    const Triangle& triangle) {
    const Point normal = triangle.unitNormal();
    const double slope = pole.normal.dot(normal);
    if (std::abs(slope) < 1e-3) {
        return std::nullopt;
    }
    const double height = normal.dot(triangle.corner(0) - pole.place) / slope;
    const Point there = pole.place + height * pole.normal;
    const Barycentric at = triangle.barycentric(there);
    if (at.minCoeff() < -onSide) {
        return std::nullopt;
    }
    const double least = splines.projector(piece).closest(there).distance;
    if (std::abs(height) > least + 1e-6 * splines.size()) {
        return std::nullopt;
    }
    return at;
}

} // namespace

std::vector<std::array<ProjectedCorner, 3>>
partsAroundPole(const SurfaceInterface& splines, int piece, const Triangle& triangle,
                const std::array<ProjectedCorner, 3>& corners) {
    for (const Pole& pole : splines.poles(piece)) {
        const std::optional<Barycentric> at = piercing(splines, piece, pole, triangle);
        if (!at || at->maxCoeff() > 1 - onSide) {
            continue;
        }
        const ProjectedCorner centre =
            projectedCorner(splines.piece(piece).patch.basis(), splines.projector(piece),
                            splines.isClosed(piece), pole.place);
        std::vector<std::array<ProjectedCorner, 3>> parts;
        for (int i = 0; i < 3; ++i) {
            if ((*at)[i] > onSide) {
                parts.push_back({corners[(i + 1) % 3], corners[(i + 2) % 3], centre});
            }
        }
        return parts;
    }
    return {corners};
}

} // namespace tokay::mapper
