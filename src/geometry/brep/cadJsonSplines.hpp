// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/LocatedNode.hpp"
#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// Curve of a cad.json file ("degree", "knot_vector", "control_points"), cut to
/// its "active_range".
/// @throws InputError with the place in the file
NurbsCurve readCurve(const LocatedNode& node);

/// Surface of a cad.json file ("degrees", "knot_vectors", "control_points").
/// @throws InputError with the place in the file
NurbsSurface readSurface(const LocatedNode& node);

} // namespace tokay::geometry
