#include "igaStructure/caseFile/readLine.hpp"

#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/readGeometry.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"

namespace tokay::structure {

namespace {

bool isBeam(const CaseSection& file) {
    return file.section("model").text("kinematics") == "beam";
}

std::string owner(const CaseSection& file) {
    return isBeam(file) ? "a beam" : "a cable";
}

// E, or E/(1 - nu^2) where the section cannot strain across the plane.
double axialModulus(const CaseSection& model, const CaseSection& material, bool beam) {
    const bool isPlaneStrain = model.has("section") ? model.text("section") == "planeStrain" : beam;
    material.require("poissonsRatio", "beam and cable need it");
    const double nu = material.number("poissonsRatio");
    return material.number("youngsModulus") / (isPlaneStrain ? 1 - nu * nu : 1);
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

LineSection readSection(const CaseSection& file) {
    const CaseSection model = file.section("model");
    const CaseSection material = file.section("material");
    const CaseSection damping = material.section("rayleighDamping");
    const bool beam = isBeam(file);
    requireUsable(model, beam);
    LineSection section;
    section.thickness = model.number("thickness");
    section.width = numberOr(model, "width", 1);
    const double area = section.thickness * section.width;
    const double secondMoment = area * section.thickness * section.thickness / 12;
    const double modulus = axialModulus(model, material, beam);
    const double density = material.number("density");
    section.axialStiffness = modulus * area;
    section.bendingStiffness = beam ? modulus * secondMoment : 0;
    section.prestress = numberOr(model, "prestress", 0) * area;
    section.mass = density * area;
    if (model.has("rotaryInertia") && model.yesNo("rotaryInertia")) {
        section.rotaryInertia = density * secondMoment;
    }
    section.massDamping = damping.number("mass");
    section.stiffnessDamping = damping.number("stiffness");
    return section;
}

LineEnd readEnd(const CaseSection& section) {
    return section.text("end") == "start" ? LineEnd::start : LineEnd::end;
}

std::vector<LineSupport> readSupports(const CaseSection& file) {
    std::vector<LineSupport> supports;
    const std::vector<std::string> components = isBeam(file)
                                                    ? std::vector<std::string>{"x", "y", "rotation"}
                                                    : std::vector<std::string>{"x", "y"};
    for (const CaseSection& section : file.list("supports")) {
        requireUsed(section, {"end", "fix"}, owner(file));
        section.require("end", owner(file) + " is held there");
        LineSupport support{readEnd(section)};
        for (const std::string& component : section.words("fix", components, owner(file))) {
            (component == "x" ? support.x : component == "y" ? support.y : support.rotation) = true;
        }
        supports.push_back(support);
    }
    return supports;
}

std::array<Formula, 2> pair(const CaseSection& section, const std::string& name) {
    std::vector<Formula> formulas = section.formulas(name, 2);
    return {std::move(formulas[0]), std::move(formulas[1])};
}

void readEndLoad(const CaseSection& section, bool beam, LineLoads& loads) {
    requireUsed(section, {"end", "force", "moment"}, "end");
    EndLoad load{readEnd(section), std::nullopt, std::nullopt};
    if (section.has("force")) {
        load.force = pair(section, "force");
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

LineLoads readLoads(const CaseSection& file) {
    LineLoads loads;
    for (const CaseSection& section : file.list("loads")) {
        requireUsed(section, {"end", "force", "moment", "traction", "gravity", "pressure"},
                    owner(file));
        if (section.has("end")) {
            readEndLoad(section, isBeam(file), loads);
            continue;
        }
        const std::string kind = section.exactlyOne({"traction", "gravity", "pressure"});
        if (kind == "traction") {
            loads.tractions.push_back(pair(section, kind));
        } else if (kind == "gravity") {
            loads.gravities.push_back(pair(section, kind));
        } else {
            loads.pressures.push_back(section.formula(kind));
        }
    }
    return loads;
}

} // namespace

LineCase readLine(const CaseSection& file) {
    return {readCurve(file), readSection(file),
            file.section("model").text("strains") == "linear" ? Strains::linear
                                                              : Strains::nonlinear,
            readSupports(file), readLoads(file)};
}

} // namespace tokay::structure
