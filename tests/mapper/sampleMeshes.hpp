// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SurfaceMesh.hpp"

namespace tokay::mapper {

enum class FaceKind { triangles, quadrilaterals, polygons };

/// Mesh of the rectangle [0, sizeX] x [0, sizeY] with its inner vertices moved by
/// up to a fifth of a cell; the seed makes different meshes. Polygons are
/// hexagons: pairs of quadrilaterals with a vertex in two of their sides.
SurfaceMesh flatMesh(int nX, int nY, FaceKind kind, ValuesAt valuesAt, double sizeX = 2,
                     double sizeY = 1, int seed = 0);

} // namespace tokay::mapper
