// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/readBeam.hpp"

#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"
#include "igaStructure/kinematics/readGeometry.hpp"
#include "igaStructure/kinematics/readMaterial.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

bool isBeam(const CaseSection& file) {
    return file.section("model").text("kinematics") == "beam";
}

bool isInSpace(const CaseSection& file) {
    return curveDimension(file) == 3;
}

std::string owner(const CaseSection& file) {
    return std::string(isBeam(file) ? "a beam" : "a cable") + (isInSpace(file) ? " in space" : "");
}

// E, or E/(1 - nu^2) where the section cannot strain across the plane.
double axialModulus(const CaseSection& model, const ElasticMaterial& material,
                    bool isPlaneStrainByDefault) {
    const bool isPlaneStrain =
        model.has("section") ? model.text("section") == "planeStrain" : isPlaneStrainByDefault;
    return isPlaneStrain ? material.planeStressModulus() : material.youngsModulus;
}

double numberOr(const CaseSection& section, const std::string& name, double otherwise) {
    return section.has(name) ? section.number(name) : otherwise;
}

void requireUsable(const CaseSection& model, bool beam) {
    if (beam) {
        requireUsed(model,
                    {"kinematics", "strains", "thickness", "width", "section", "rotaryInertia"},
                    "beam");
    } else {
        requireUsed(model, {"kinematics", "strains", "thickness", "width", "section", "prestress"},
                    "cable");
    }
    model.require("thickness", "beam and cable need it");
    if (model.has("rotaryInertia") && model.yesNo("rotaryInertia") &&
        model.text("strains") == "nonlinear") {
        throw model.error("rotaryInertia", "has no meaning with nonlinear strains: it would make "
                                           "the mass depend on the motion; remove it");
    }
    if (!beam && model.text("strains") == "linear" && !model.has("prestress")) {
        throw model.error("", "entry 'prestress' is missing: a cable with linear strains has no "
                              "other stiffness across its axis");
    }
}

void requireUsableInSpace(const CaseSection& model, bool beam) {
    if (model.has("section") && model.text("section") == "planeStrain") {
        throw model.error("section", "planeStrain has no meaning in space, where a line is a rod "
                                     "with the modulus E; remove it");
    }
    if (beam && model.has("width") && model.number("width") != model.number("thickness")) {
        throw model.error("width", fmt::format("{:g} is not the thickness {:g}: in space a beam "
                                               "bends alike in all directions, so its section is "
                                               "a square; remove it",
                                               model.number("width"), model.number("thickness")));
    }
}

BeamSection readSection(const CaseSection& file) {
    const CaseSection model = file.section("model");
    const ElasticMaterial material = readMaterial(file);
    const bool beam = isBeam(file);
    const bool inSpace = isInSpace(file);
    requireUsable(model, beam);
    if (inSpace) {
        requireUsableInSpace(model, beam);
    }
    BeamSection section;
    section.thickness = model.number("thickness");
    section.width = numberOr(model, "width", inSpace ? section.thickness : 1);
    const double area = section.thickness * section.width;
    const double secondMoment = area * section.thickness * section.thickness / 12;
    const double modulus = axialModulus(model, material, beam && !inSpace);
    section.axialStiffness = modulus * area;
    section.bendingStiffness = beam ? modulus * secondMoment : 0;
    section.prestress = numberOr(model, "prestress", 0) * area;
    section.mass = material.density * area;
    if (model.has("rotaryInertia") && model.yesNo("rotaryInertia")) {
        section.rotaryInertia = material.density * secondMoment;
    }
    section.massDamping = material.massDamping;
    section.stiffnessDamping = material.stiffnessDamping;
    return section;
}

BeamEnd readEnd(const CaseSection& section) {
    return section.text("end") == "start" ? BeamEnd::start : BeamEnd::end;
}

std::vector<BeamSupport> readBeamSupports(const CaseSection& file) {
    std::vector<BeamSupport> supports;
    std::vector<std::string> components = {"x", "y"};
    if (isInSpace(file)) {
        components.push_back("z");
    }
    if (isBeam(file)) {
        components.push_back("rotation");
    }
    for (const CaseSection& section : file.list("supports")) {
        requireUsed(section, {"end", "fix"}, owner(file));
        section.require("end", owner(file) + " is held there");
        BeamSupport support{readEnd(section)};
        for (const std::string& component : section.words("fix", components, owner(file))) {
            (component == "x"   ? support.x
             : component == "y" ? support.y
             : component == "z" ? support.z
                                : support.rotation) = true;
        }
        supports.push_back(support);
    }
    return supports;
}

void requireNoFollower(const CaseSection& section) {
    if (section.has("moment")) {
        throw section.error("moment", "has no meaning in space, where a moment that turns with the "
                                      "end has no one axis; give a force");
    }
    if (section.has("pressure")) {
        throw section.error("pressure", "has no meaning in space, where a line has no side; give "
                                        "traction");
    }
}

void readEndLoad(const CaseSection& section, bool beam, int dimension, BeamLoads& loads) {
    requireUsed(section, {"end", "force", "moment"}, "end");
    EndLoad load{readEnd(section), std::nullopt, std::nullopt};
    if (section.has("force")) {
        load.force = section.formulas("force", dimension);
    }
    if (section.has("moment")) {
        if (!beam) {
            throw section.error("moment", "has no meaning for a cable; remove it");
        }
        load.moment = section.formula("moment");
    }
    if (!load.force && !load.moment) {
        throw section.error("", "give force or moment at the end");
    }
    loads.ends.push_back(std::move(load));
}

BeamLoads readBeamLoads(const CaseSection& file) {
    BeamLoads loads;
    const int dimension = curveDimension(file);
    for (const CaseSection& section : file.list("loads")) {
        requireUsed(section, {"end", "force", "moment", "traction", "gravity", "pressure"},
                    owner(file));
        if (dimension == 3) {
            requireNoFollower(section);
        }
        if (section.has("end")) {
            readEndLoad(section, isBeam(file), dimension, loads);
            continue;
        }
        const std::string kind = section.exactlyOne({"traction", "gravity", "pressure"});
        if (kind == "traction") {
            loads.tractions.push_back(section.formulas(kind, dimension));
        } else if (kind == "gravity") {
            loads.gravities.push_back(section.formulas(kind, dimension));
        } else {
            loads.pressures.push_back(section.formula(kind));
        }
    }
    return loads;
}

// What a closed curve is taken for must not be silent: its ends are not joined.
geometry::NurbsCurve readAxis(const CaseSection& file) {
    geometry::NurbsCurve curve = readCurve(file);
    const geometry::Points& points = curve.controlPoints();
    const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
    const double gap = (points.row(0) - points.row(points.rows() - 1)).norm();
    constexpr double sameEnds = 1e-9;
    if (gap <= sameEnds * size && !isSlit(file)) {
        throw file.section("geometry")
            .error("", fmt::format("the curve ends where it starts, but {} is not joined to "
                                   "itself: model a part with supports of symmetry, or take a "
                                   "plane solid or a shell; slit: yes leaves it open",
                                   owner(file)));
    }
    return curve;
}

} // namespace

BeamDescription readBeam(const CaseSection& file) {
    if (isInSpace(file) && file.has("coupling")) {
        throw file.error("coupling", owner(file) + " cannot be coupled: without torsion nothing "
                                                   "says how its surface moves; couple a shell or "
                                                   "solid, or a line in the plane");
    }
    return {readAxis(file),
            readSection(file),
            file.section("model").text("strains") == "linear" ? Strains::linear
                                                              : Strains::nonlinear,
            readBeamSupports(file),
            readBeamLoads(file),
            curveDimension(file)};
}

} // namespace tokay::structure
