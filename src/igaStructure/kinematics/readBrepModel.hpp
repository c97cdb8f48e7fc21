// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"

#include <string>

namespace tokay::structure {

class CaseSection;

/// The surfaces of a shell: a primitive, a NURBS patch or a cad.json file, in the
/// basis of the displacement.
/// @param directory  of the case file, to which a cad.json file is relative
geometry::BrepModel readBrepModel(const CaseSection& file, const std::string& directory);

/// The surface that `geometry` gives by the shape, as it is.
/// @param shape  rectangle, plate, cylinder or nurbs
geometry::NurbsSurface readSpatialSurface(const CaseSection& geometry, const std::string& shape);

} // namespace tokay::structure
