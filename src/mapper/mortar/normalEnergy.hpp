// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/SparseMatrix.hpp"
#include "mapper/interface/CurveInterface.hpp"

namespace tokay::mapper {

/// The gradient term of an interface: integral over the whole elements that its
/// trimmed edges cut of (du/dn)^2, n along the surface and normal to the edge,
/// nValues x nValues. Empty if no curve is the edge of a patch.
SparseMatrix normalEnergy(const CurveInterface& interface);

} // namespace tokay::mapper
