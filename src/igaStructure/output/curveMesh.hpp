// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "igaStructure/output/VtuMesh.hpp"

namespace tokay::structure {

/// The strip of a thickness around a plane curve: each element cut into
/// subdivision quadrilaterals, which reach from side to side.
VtuMesh stripMesh(const geometry::NurbsCurve& curve, int subdivision, double thickness);

/// Straight pieces of a curve in space, subdivision an element.
VtuMesh segmentMesh(const geometry::NurbsCurve& curve, int subdivision);

/// A VTK_BEZIER_CURVE for each element, exact as bezierMesh of a surface.
VtuMesh bezierMesh(const geometry::NurbsCurve& curve);

} // namespace tokay::structure
