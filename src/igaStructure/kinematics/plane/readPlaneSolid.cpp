// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/readPlaneSolid.hpp"

#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"
#include "igaStructure/kinematics/readGeometry.hpp"
#include "igaStructure/kinematics/readMaterial.hpp"

namespace tokay::structure {

namespace {

PlaneMaterial readPlaneMaterial(const CaseSection& file) {
    const CaseSection model = file.section("model");
    PlaneMaterial material{readMaterial(file)};
    if (model.text("kinematics") == "planeStrain") {
        requireUsed(model, {"kinematics", "strains"}, "planeStrain");
        return material;
    }
    requireUsed(model, {"kinematics", "strains", "thickness"}, "planeStress");
    material.kinematics = Kinematics::planeStress;
    model.require("thickness", "planeStress needs it");
    material.thickness = model.number("thickness");
    return material;
}

std::vector<Support> readPlaneSupports(const CaseSection& file) {
    std::vector<Support> supports;
    for (const CaseSection& section : file.list("supports")) {
        requireUsed(section, {"edge", "fix"}, "a plane solid");
        section.require("edge", "a plane solid is held there");
        Support support{geometry::edgeFromName(section.text("edge")), {false, false}};
        for (const std::string& component : section.words("fix", {"x", "y"}, "a plane solid")) {
            support.fixed[component == "x" ? 0 : 1] = true;
        }
        supports.push_back(support);
    }
    return supports;
}

std::array<Formula, 2> pair(const CaseSection& section, const std::string& name) {
    std::vector<Formula> formulas = section.formulas(name, 2);
    return {std::move(formulas[0]), std::move(formulas[1])};
}

Loads readPlaneLoads(const CaseSection& file) {
    Loads loads;
    for (const CaseSection& section : file.list("loads")) {
        requireUsed(section, {"edge", "traction", "gravity"}, "a plane solid");
        const bool onEdge = section.has("edge") && section.has("traction");
        const bool onEdgeOrPart = section.has("edge") || section.has("traction");
        if (section.has("gravity") == onEdgeOrPart || onEdge != onEdgeOrPart) {
            throw section.error("", "give either edge and traction, or gravity alone");
        }
        if (onEdge) {
            loads.tractions.push_back(
                {geometry::edgeFromName(section.text("edge")), pair(section, "traction")});
        } else {
            loads.gravities.push_back({pair(section, "gravity")});
        }
    }
    return loads;
}

} // namespace

PlaneSolidCase readPlaneSolid(const CaseSection& file) {
    return {readSurface(file),
            file.section("model").text("strains") == "linear" ? Strains::linear
                                                              : Strains::nonlinear,
            readPlaneMaterial(file),
            readPlaneSupports(file),
            readPlaneLoads(file),
            isSlit(file)};
}

} // namespace tokay::structure
