// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsVolume.hpp"
#include "igaStructure/output/VtuMesh.hpp"

namespace tokay::structure {

/// Each element of the volume cut into subdivision^3 hexahedra; elements do not share
/// points, so that a field may jump between them.
VtuMesh hexahedronMesh(const geometry::NurbsVolume& volume, int subdivision);

/// A VTK_BEZIER_HEXAHEDRON for each element, as bezierMesh of a surface.
VtuMesh bezierMesh(const geometry::NurbsVolume& volume);

} // namespace tokay::structure
