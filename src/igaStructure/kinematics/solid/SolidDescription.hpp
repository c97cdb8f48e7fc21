// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsVolume.hpp"
#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/Field.hpp"
#include "igaStructure/assembly/SupportTrace.hpp"

#include <array>
#include <string>
#include <vector>

namespace tokay::structure {

/// Support of a side, or of the edge or corner at which several sides meet.
struct SolidSupport {
    std::vector<geometry::Side> sides;
    std::array<bool, 3> fixed = {false, false, false};
    SupportMotion motion = nullptr;
    std::string name = {};
};

/// Loads of a solid; those that follow the deformation are pressures.
struct SolidLoads {
    struct Traction {
        geometry::Side side;
        VectorField traction; ///< per reference area [Pa]
    };
    struct Pressure {
        geometry::Side side;
        ScalarField pressure; ///< against the outward normal, on the current area [Pa]
    };

    std::vector<Traction> tractions;
    std::vector<Pressure> pressures;
    std::vector<VectorField> gravities; ///< acceleration [m/s^2]
};

/// Description of a solid: volume, material, supports and loads.
struct SolidDescription {
    geometry::NurbsVolume volume; ///< in the basis of the displacement
    ElasticMaterial material = {};
    Strains strains = Strains::nonlinear;
    std::vector<SolidSupport> supports = {};
    SolidLoads loads = {};
    bool isSlit = false; ///< opposite sides that coincide stay apart
};

} // namespace tokay::structure
