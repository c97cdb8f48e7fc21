// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/interface/SurfaceMesh.hpp"

namespace tokay::mapper {

/// The trimmed knot spans of patches cut into triangles, none over a knot line.
struct SplineFacets {
    SurfaceMesh mesh;
    /// Patch of each triangle.
    std::vector<int> pieces;
};

/// @param chordTolerance  of the triangles to patches and loops, over the mean
///                        size of a knot span
SplineFacets splineFacets(const SurfaceInterface& splines, double chordTolerance);

} // namespace tokay::mapper
