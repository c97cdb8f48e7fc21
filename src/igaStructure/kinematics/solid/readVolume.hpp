// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsVolume.hpp"

namespace tokay::structure {

class CaseSection;

/// The volume of `geometry` in the basis of `discretisation`: a block, a NURBS volume,
/// or what lies within half of `model.thickness` on either side of a surface.
/// @throws InputError if the entries do not fit each other or describe no volume
geometry::NurbsVolume readVolume(const CaseSection& file);

} // namespace tokay::structure
