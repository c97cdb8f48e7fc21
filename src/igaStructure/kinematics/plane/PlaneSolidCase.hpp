// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/kinematics/plane/Loads.hpp"
#include "igaStructure/kinematics/plane/PlaneMaterial.hpp"
#include "igaStructure/kinematics/plane/Supports.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"

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

/// Description of a plane solid of trimmed patches: a membrane that stays in its plane.
struct PlanePatchesCase {
    ShellDescription membrane; ///< isPlane; with the material that is the same in plane stress
    PlaneMaterial material;
};

} // namespace tokay::structure
