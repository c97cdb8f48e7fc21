// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "igaStructure/assembly/Strains.hpp"
#include "igaStructure/kinematics/beam/LineLoads.hpp"
#include "igaStructure/kinematics/beam/LineSection.hpp"

namespace tokay::structure {

/// What a case file says of a beam or cable.
struct LineCase {
    geometry::NurbsCurve curve; ///< refined
    LineSection section;
    Strains strains;
    std::vector<LineSupport> supports;
    LineLoads loads;
    int dimension; ///< 2: in the plane z = 0; 3: in space
};

} // namespace tokay::structure
