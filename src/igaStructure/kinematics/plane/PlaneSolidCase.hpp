// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/Strains.hpp"
#include "igaStructure/kinematics/plane/Loads.hpp"
#include "igaStructure/kinematics/plane/Material.hpp"
#include "igaStructure/kinematics/plane/Supports.hpp"

namespace tokay::structure {

/// What a case file says of a plane solid.
struct PlaneSolidCase {
    geometry::NurbsSurface surface; ///< refined
    Strains strains;
    Material material;
    std::vector<Support> supports;
    Loads loads;
};

} // namespace tokay::structure
