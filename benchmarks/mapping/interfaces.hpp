// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/CurveInterface.hpp"
#include "mapper/interface/SplineInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/interface/SurfaceMesh.hpp"

/// Interfaces of the benchmarks: the curve y = 0.2 x (1 - x) and the surface
/// z = 1.6 x (1 - x) y (1 - y) over the unit square, as splines, which are them
/// exactly, and as meshes with their vertices on them, uneven so that no two match.
namespace tokay::benchmark {

using geometry::Point;
using geometry::Points;

mapper::CurveInterface lines(int n, int seed,
                             mapper::ValuesAt valuesAt = mapper::ValuesAt::vertices);
/// Of degree 2 at least.
mapper::SplineInterface curve(int degree, int nSpans);

/// About n x n faces: quadrilaterals, or each cut into two triangles.
mapper::SurfaceMesh quadrilaterals(int n, int seed, mapper::ValuesAt valuesAt);
mapper::SurfaceMesh triangles(int n, int seed, mapper::ValuesAt valuesAt);

enum class Trimmed { no, hole };

/// n x n spans, of degree 2 at least; the hole has its centre at (0.47, 0.52) and the radius 0.2.
mapper::SurfaceInterface patch(int degree, int n, Trimmed trimmed);
bool isInHole(const Point& point);

} // namespace tokay::benchmark
