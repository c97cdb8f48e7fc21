// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/ModelEntries.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

using LawChoices = Choices<MaterialLaw, ElasticMaterial>;

LawChoices lawChoices(Laws laws) {
    const SchemaOf<ElasticMaterial> poissonsRatio = {{"poissonsRatio",
                                                      &ElasticMaterial::poissonsRatio, "(-1, 0.5)",
                                                      "", "Poisson's ratio.", required}};
    LawChoices choices = {
        {"StVenantKirchhoff", MaterialLaw::stVenantKirchhoff,
         "linear relation between second Piola-Kirchhoff stress and Green-Lagrange strain "
         "(Hooke's law with linear strains).",
         poissonsRatio}};
    if (laws != Laws::linear) {
        choices.push_back({"neoHookean", MaterialLaw::neoHookean,
                           "compressible neo-Hookean material.", poissonsRatio});
    }
    if (laws == Laws::all) {
        choices.push_back({"incompressibleNeoHookean",
                           MaterialLaw::incompressibleNeoHookean,
                           "neo-Hookean material with Poisson's ratio 0.5.",
                           {}});
    }
    return choices;
}

const LawChoices& choicesOf(Laws laws) {
    static const LawChoices choices[] = {lawChoices(Laws::linear), lawChoices(Laws::compressible),
                                         lawChoices(Laws::all)};
    return choices[static_cast<int>(laws)];
}

SchemaOf<ElasticMaterial> dampingSchema() {
    return {
        {"mass", &ElasticMaterial::massDamping, "[0, inf)", "1/s", "Factor of the mass matrix."},
        {"stiffness", &ElasticMaterial::stiffnessDamping, "[0, inf)", "s",
         "Factor of the stiffness matrix."}};
}

} // namespace

SchemaOf<ElasticMaterial> materialSchema(Laws laws) {
    return {{"type", &ElasticMaterial::law, choicesOf(laws), "Material law.", required},
            {"youngsModulus", &ElasticMaterial::youngsModulus, "(0, inf)", "Pa", "Young's modulus.",
             required},
            {"density", &ElasticMaterial::density, "(0, inf)", "kg/m^3",
             "Density in the reference configuration.", required},
            {"rayleighDamping", dampingSchema(),
             "Damping matrix C = mass M + stiffness K, K being the tangent of the undeformed "
             "body."}};
}

const Choices<Fixed>& planeComponents() {
    static const Choices<Fixed> choices = {{"x", Fixed::x}, {"y", Fixed::y}};
    return choices;
}

const Choices<Fixed>& spatialComponents() {
    static const Choices<Fixed> choices = {{"x", Fixed::x}, {"y", Fixed::y}, {"z", Fixed::z}};
    return choices;
}

const Choices<Fixed>& componentsAndRotation() {
    static const Choices<Fixed> choices = {
        {"x", Fixed::x}, {"y", Fixed::y}, {"z", Fixed::z}, {"rotation", Fixed::rotation}};
    return choices;
}

SupportMotion supportMotion(const Located& support, const std::vector<Formula>& displacement,
                            const std::vector<bool>& fixed) {
    const auto isZero = [](const Formula& f) {
        return !f.dependsOnTime() && !f.dependsOnPlace() && f({0, 0, 0}, 0) == 0;
    };
    std::array<Formula, 3> all;
    bool isAtRest = true;
    for (std::size_t c = 0; c < displacement.size(); ++c) {
        if (!fixed[c] && !isZero(displacement[c])) {
            throw support.error("displacement",
                                fmt::format("has the formula '{}' for {}, which is not in fix and "
                                            "so is free: add it to fix, or give 0 here",
                                            displacement[c].text(), "xyz"[c]));
        }
        isAtRest = isAtRest && isZero(displacement[c]);
        all[c] = displacement[c];
    }
    return isAtRest ? nullptr : std::make_shared<const VectorField>(vectorField(all));
}

VectorField vectorField(const std::array<Formula, 3>& f) {
    return {[f](const geometry::Point& x, double t) {
                return Eigen::Vector3d(f[0](x, t), f[1](x, t), f[2](x, t));
            },
            std::any_of(f.begin(), f.end(), [](const Formula& g) { return g.dependsOnTime(); }),
            std::any_of(f.begin(), f.end(), [](const Formula& g) { return g.dependsOnPlace(); })};
}

ScalarField scalarField(const Formula& f) {
    return {[f](const geometry::Point& x, double t) { return f(x, t); }, f.dependsOnTime(),
            f.dependsOnPlace()};
}

} // namespace tokay::structure
