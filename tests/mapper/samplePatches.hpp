// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SurfaceInterface.hpp"

namespace tokay::mapper {

/// An interface of one patch, control points numbered as the patch's.
SurfaceInterface onePatch(geometry::TrimmedPatch patch);

/// [0, 2] x [0, 1], biquadratic.
geometry::NurbsSurface plate(int nX, int nY);

/// The same plate with lines of the parameters that are neither straight nor even.
geometry::NurbsSurface bentParameters(int nX, int nY);

/// The plate of nX x nY spans with a round hole in the parameters.
geometry::TrimmedPatch holedPlate(int nX = 5, int nY = 4);

/// Two patches that share the control points at x = 1, together the plate.
SurfaceInterface twoPatches();

} // namespace tokay::mapper
