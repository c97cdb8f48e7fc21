// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/readMaterial.hpp"

#include "igaStructure/caseFile/CaseSection.hpp"

#include <algorithm>

namespace tokay::structure {

namespace {

MaterialLaw lawFromName(const std::string& name) {
    return name == "neoHookean"                 ? MaterialLaw::neoHookean
           : name == "incompressibleNeoHookean" ? MaterialLaw::incompressibleNeoHookean
                                                : MaterialLaw::stVenantKirchhoff;
}

} // namespace

ElasticMaterial readMaterial(const CaseSection& file) {
    const CaseSection section = file.section("material");
    const CaseSection damping = section.section("rayleighDamping");
    ElasticMaterial material;
    material.youngsModulus = section.number("youngsModulus");
    material.density = section.number("density");
    material.massDamping = damping.number("mass");
    material.stiffnessDamping = damping.number("stiffness");
    material.law = lawFromName(section.text("type"));
    if (material.law == MaterialLaw::incompressibleNeoHookean) {
        material.poissonsRatio = 0.5;
        return material;
    }
    section.require("poissonsRatio", section.text("type") + " needs it");
    material.poissonsRatio = section.number("poissonsRatio");
    return material;
}

VectorField readVectorField(const CaseSection& section, const std::string& name) {
    const std::vector<Formula> f = section.formulas(name, 3);
    return {[f](const geometry::Point& x, double t) {
                return Eigen::Vector3d(f[0](x, t), f[1](x, t), f[2](x, t));
            },
            std::any_of(f.begin(), f.end(), [](const Formula& g) { return g.dependsOnTime(); }),
            std::any_of(f.begin(), f.end(), [](const Formula& g) { return g.dependsOnPlace(); })};
}

ScalarField readScalarField(const CaseSection& section, const std::string& name) {
    const Formula f = section.formula(name);
    return {[f](const geometry::Point& x, double t) { return f(x, t); }, f.dependsOnTime(),
            f.dependsOnPlace()};
}

} // namespace tokay::structure
