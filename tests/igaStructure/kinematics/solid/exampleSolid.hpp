// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"

#include <cmath>
#include <ostream>
#include <vector>

namespace tokay::structure {

/// Kinds of plane bodies that tests go through: a rectangle 0.1 x 1, or a
/// quarter of a ring with the radii 0.5 and 0.8 (rational).
struct Example {
    Kinematics kinematics;
    Strains strains;
    bool ring;
};

inline std::ostream& operator<<(std::ostream& stream, const Example& example) {
    return stream << (example.kinematics == Kinematics::planeStrain ? "plane strain"
                                                                    : "plane stress")
                  << (example.strains == Strains::linear ? ", linear" : ", nonlinear")
                  << (example.ring ? ", ring" : ", rectangle");
}

inline std::vector<Example> exampleKinds() {
    std::vector<Example> kinds;
    for (Kinematics kinematics : {Kinematics::planeStrain, Kinematics::planeStress}) {
        for (Strains strains : {Strains::linear, Strains::nonlinear}) {
            for (bool ring : {false, true}) {
                kinds.push_back({kinematics, strains, ring});
            }
        }
    }
    return kinds;
}

inline PlaneMaterial exampleMaterial(Kinematics kinematics) {
    PlaneMaterial material;
    material.kinematics = kinematics;
    material.youngsModulus = 4e6;
    material.poissonsRatio = 0.3;
    material.density = 3000;
    material.thickness = kinematics == Kinematics::planeStress ? 0.2 : 1;
    return material;
}

inline double exampleMass(const Example& example) {
    const double area = example.ring ? 0.25 * M_PI * (0.8 * 0.8 - 0.5 * 0.5) : 0.1;
    return 3000 * area * exampleMaterial(example.kinematics).thickness;
}

inline PlaneSolid makeExample(const Example& example) {
    const geometry::NurbsSurface coarse =
        example.ring ? geometry::ringSector({0, 0, 0}, 0.5, 0.8, 0, 0.5 * M_PI)
                     : geometry::rectangle({0, 0, 0}, 0.1, 1);
    return {geometry::refine(coarse, 2, 3, 2, 4),
            exampleMaterial(example.kinematics),
            example.strains,
            {{geometry::Edge::bottom, {true, true}}},
            {}};
}

} // namespace tokay::structure
