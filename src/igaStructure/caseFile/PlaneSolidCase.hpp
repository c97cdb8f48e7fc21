#pragma once

#include "igaStructure/model/Loads.hpp"
#include "igaStructure/model/Material.hpp"
#include "igaStructure/model/Strains.hpp"
#include "igaStructure/model/Supports.hpp"

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
