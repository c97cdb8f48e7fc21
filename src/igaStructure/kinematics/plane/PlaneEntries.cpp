// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneEntries.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

void requireOneKind(const PlaneLoad& load) {
    const bool isOnEdge = load.edge || load.brepEdge;
    if (load.traction.has_value() == load.gravity.has_value() ||
        load.traction.has_value() != isOnEdge) {
        throw load.error("", "give either edge and traction, or gravity alone");
    }
}

// Entries of models of trimmed patches do not go with other shapes.
template <class Model>
void requireOnePatch(const PlaneEntries<Model>& entries) {
    const auto refuse = [](const Located& where, const char* entry, bool isGiven) {
        if (isGiven) {
            throw where.error(entry, "goes with geometry.cadJson");
        }
    };
    refuse(entries.geometry, "tolerance", entries.geometry.tolerance.has_value());
    refuse(entries.model, "edgeMethod", entries.model.edgeMethod.has_value());
    refuse(entries.model, "penalty", entries.model.penalty.has_value());
    refuse(entries.model, "sliverTreatment", entries.model.sliverTreatment.has_value());
    for (const PlaneSupport& support : entries.supports) {
        refuse(support, "brepEdge", support.brepEdge.has_value());
        refuse(support, "weak", support.weak.has_value());
        if (!support.edge) {
            throw support.error("", "entry 'edge' is missing: Constrained edge of a single patch");
        }
    }
    for (const PlaneLoad& load : entries.loads) {
        refuse(load, "brepEdge", load.brepEdge.has_value());
    }
}

Loads makeLoads(const std::vector<PlaneLoad>& all) {
    Loads loads;
    for (const PlaneLoad& load : all) {
        requireOneKind(load);
        if (load.traction) {
            loads.tractions.push_back({*load.edge, *load.traction});
        } else {
            loads.gravities.push_back({*load.gravity});
        }
    }
    return loads;
}

template <class Model>
PlaneMaterial makeMaterial(const PlaneEntries<Model>& entries, Kinematics kinematics) {
    PlaneMaterial material{entries.material.material()};
    material.kinematics = kinematics;
    material.thickness = entries.model.thickness;
    return material;
}

template <class Model>
PlaneSolidCase makePatch(const PlaneEntries<Model>& entries, Kinematics kinematics) {
    requireOnePatch(entries);
    for (const std::string& name : entries.coupling.interface) {
        entries.coupling.at("interface", [&] { return geometry::edgeFromName(name); });
    }
    std::vector<Support> supports;
    for (const PlaneSupport& support : entries.supports) {
        const std::array<bool, 2> fixed = fixedComponents<2>(support.fix);
        supports.push_back({*support.edge, fixed,
                            supportMotion(support, support.displacement, fixed),
                            nameOf(*support.edge, edgeChoices())});
    }
    const PlaneGeometry& shape = entries.geometry;
    return {refined(shape.rectangle ? shape.rectangle->surface() : shape.nurbs->surface(),
                    entries.discretisation),
            entries.model.strains,
            makeMaterial(entries, kinematics),
            supports,
            makeLoads(entries.loads),
            shape.isSlit};
}

// The entries of a membrane keep their places in the file, for messages.
template <class Entries>
Entries at(const Located& where) {
    Entries entries;
    static_cast<Located&>(entries) = where;
    return entries;
}

std::array<Formula, 3> inSpace(const std::array<Formula, 2>& formulas) {
    return {formulas[0], formulas[1], Formula()};
}

MembraneSupport inSpace(const PlaneSupport& support) {
    auto own = at<MembraneSupport>(support);
    own.edge = support.edge;
    own.brepEdge = support.brepEdge;
    own.fix = support.fix;
    own.weak = support.weak;
    if (support.displacement) {
        own.displacement = inSpace(*support.displacement);
    }
    return own;
}

MembraneLoad inSpace(const PlaneLoad& load) {
    requireOneKind(load);
    auto own = at<MembraneLoad>(load);
    own.edge = load.edge;
    own.brepEdge = load.brepEdge;
    if (load.traction) {
        own.lineForce = inSpace(*load.traction);
    } else {
        own.gravity = inSpace(*load.gravity);
    }
    return own;
}

template <class Model>
MembraneEntries inSpace(const PlaneEntries<Model>& entries, const PlaneMaterial& material) {
    auto own = at<MembraneEntries>(entries);
    own.geometry = at<ShellGeometry>(entries.geometry);
    own.geometry.isSlit = entries.geometry.isSlit;
    own.geometry.cadJson = entries.geometry.cadJson;
    own.geometry.tolerance = entries.geometry.tolerance;
    own.discretisation = entries.discretisation;
    static_cast<ModelEntries&>(own.model) = entries.model;
    own.model.thickness = material.thickness;
    own.model.edgeMethod = entries.model.edgeMethod;
    own.model.penalty = entries.model.penalty;
    own.model.sliverTreatment = entries.model.sliverTreatment;
    static_cast<ElasticMaterial&>(own.material) = material.asPlaneStress();
    for (const PlaneSupport& support : entries.supports) {
        own.supports.push_back(inSpace(support));
    }
    for (const PlaneLoad& load : entries.loads) {
        own.loads.push_back(inSpace(load));
    }
    return own;
}

template <class Model>
PlanePatchesCase makePatches(const PlaneEntries<Model>& entries, Kinematics kinematics,
                             const CaseContext& context) {
    const PlaneMaterial material = makeMaterial(entries, kinematics);
    PlanePatchesCase patches{makeMembrane(inSpace(entries, material), context), material};
    patches.membrane.isPlane = true;
    for (ShellLoads::EdgeForce& load : patches.membrane.loads.edgeForces) {
        // Per reference area of the edge.
        load.force.value = [traction = load.force.value,
                            thickness = material.thickness](const geometry::Point& x, double t) {
            return Eigen::Vector3d(thickness * traction(x, t));
        };
    }
    for (std::size_t face = 0; face < patches.membrane.model.faces().size(); ++face) {
        const geometry::TrimmedPatch& patch = patches.membrane.model.patch(static_cast<int>(face));
        if (!patch.basis().controlPoints().col(2).isZero(0)) {
            throw entries.geometry.error(
                "cadJson", fmt::format("patch \"{}\" has a control point outside z = 0, where a "
                                       "plane solid lies",
                                       patch.name()));
        }
    }
    return patches;
}

template <class Model>
PlaneCase make(const PlaneEntries<Model>& entries, Kinematics kinematics,
               const CaseContext& context) {
    if (entries.geometry.cadJson) {
        return makePatches(entries, kinematics, context);
    }
    return makePatch(entries, kinematics);
}

} // namespace

PlaneCase makePlaneStrain(const PlaneEntries<PlaneStrainModel>& entries,
                          const CaseContext& context) {
    return make(entries, Kinematics::planeStrain, context);
}

PlaneCase makePlaneStress(const PlaneEntries<PlaneStressModel>& entries,
                          const CaseContext& context) {
    return make(entries, Kinematics::planeStress, context);
}

} // namespace tokay::structure
