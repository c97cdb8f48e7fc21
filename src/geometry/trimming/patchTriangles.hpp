// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/trimming/TrimmedPatch.hpp"

#include <array>

namespace tokay::geometry {

/// Triangles on a patch.
struct PatchTriangles {
    std::vector<Parameters> parameters;
    /// n x 3, the surface's points at the parameters [m]
    Points points;
    /// Right-handed about the surface's normal (xi x eta).
    std::vector<std::array<int, 3>> triangles;
    /// Element of each triangle.
    std::vector<int> elements;
};

/// The part of a patch inside its loops in triangles that leave the surface and
/// the loops by about chordTolerance [m]. Neighbours share corners along the
/// lines of a grid, but not along the loops.
/// @throws InputError if the tolerance is not positive.
PatchTriangles patchTriangles(const TrimmedPatch& patch, double chordTolerance);

} // namespace tokay::geometry
