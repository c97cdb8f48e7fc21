#pragma once

#include "mapper/interface/CurveInterface.hpp"
#include "mapper/SparseMatrix.hpp"

namespace tokay::mapper {

/// The gradient term of an interface: integral over the whole elements that its
/// trimmed edges cut of (du/dn)^2, n along the surface and normal to the edge,
/// nValues x nValues. Empty if no curve is the edge of a patch.
SparseMatrix normalEnergy(const CurveInterface& interface);

} // namespace tokay::mapper
