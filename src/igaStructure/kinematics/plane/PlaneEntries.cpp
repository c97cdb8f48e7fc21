// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneEntries.hpp"

namespace tokay::structure {

namespace {

Loads makeLoads(const std::vector<PlaneLoad>& all) {
    Loads loads;
    for (const PlaneLoad& load : all) {
        const bool isOnEdge = load.edge && load.traction;
        const bool isOnEdgeOrPart = load.edge || load.traction;
        if (load.gravity.has_value() == isOnEdgeOrPart || isOnEdge != isOnEdgeOrPart) {
            throw load.error("", "give either edge and traction, or gravity alone");
        }
        if (isOnEdge) {
            loads.tractions.push_back({*load.edge, *load.traction});
        } else {
            loads.gravities.push_back({*load.gravity});
        }
    }
    return loads;
}

template <class Model>
PlaneSolidCase make(const PlaneEntries<Model>& entries, Kinematics kinematics) {
    PlaneMaterial material{entries.material.material()};
    material.kinematics = kinematics;
    material.thickness = entries.model.thickness;
    std::vector<Support> supports;
    for (const PlaneSupport& support : entries.supports) {
        const std::array<bool, 2> fixed = fixedComponents<2>(support.fix);
        supports.push_back({support.edge, fixed,
                            supportMotion(support, support.displacement, fixed),
                            nameOf(support.edge, edgeChoices())});
    }
    const PlaneGeometry& shape = entries.geometry;
    return {refined(shape.rectangle ? shape.rectangle->surface() : shape.nurbs->surface(),
                    entries.discretisation),
            entries.model.strains,
            material,
            supports,
            makeLoads(entries.loads),
            shape.isSlit};
}

} // namespace

PlaneSolidCase makePlaneStrain(const PlaneEntries<PlaneStrainModel>& entries, const CaseContext&) {
    return make(entries, Kinematics::planeStrain);
}

PlaneSolidCase makePlaneStress(const PlaneEntries<PlaneStressModel>& entries, const CaseContext&) {
    return make(entries, Kinematics::planeStress);
}

} // namespace tokay::structure
