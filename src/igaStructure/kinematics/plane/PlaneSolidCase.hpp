// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/kinematics/plane/Loads.hpp"
#include "igaStructure/kinematics/plane/PlaneMaterial.hpp"
#include "igaStructure/kinematics/plane/Supports.hpp"

namespace tokay::structure {

/// Description of a plane solid: all that a case file says of it.
struct PlaneSolidCase {
    geometry::NurbsSurface surface; ///< refined
    Strains strains;
    PlaneMaterial material;
    std::vector<Support> supports;
    Loads loads;
    bool isSlit; ///< opposite edges that coincide stay apart
};

} // namespace tokay::structure
