// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/PatchNodes.hpp"
#include "igaStructure/kinematics/solid/SolidDescription.hpp"

#include <vector>

namespace tokay::structure {

/// Unknowns of a solid that supports fix. Open knot vectors make a side depend on
/// its own control points only, so fixing these is exact.
/// @return  3 nControlPoints, component c of control point k is 3 k + c
std::vector<bool> fixedUnknowns(const geometry::NurbsVolume& volume,
                                const std::vector<SolidSupport>& supports);

/// @throws InputError if sides have no control point in common
void requireCommonPoints(const geometry::NurbsVolume& volume,
                         const std::vector<geometry::Side>& sides);

/// Motion of the unknowns of supports that move; what another holds at rest stays so.
SupportTrace supportTrace(const SolidDescription& solid, const PatchNodes& nodes);

/// True if the pressures on a solid have a potential, so that their derivative is
/// symmetric: each is uniform on its side, and each edge of that side is constrained in
/// two components, or across a plane in which it lies, or a seam.
/// Source: Schweizerhof & Ramm 1984
bool pressuresHavePotential(const SolidDescription& solid, const PatchNodes& nodes);

} // namespace tokay::structure
