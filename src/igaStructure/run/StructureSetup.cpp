#include "igaStructure/run/StructureSetup.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

namespace {

std::string describeScheme(const TimeScheme& scheme) {
    if (!scheme.dynamic) {
        return "static";
    }
    return fmt::format("implicit, alphaM {:.4g}, alphaF {:.4g}, beta {:.4g}, gamma {:.4g}",
                       scheme.alphaM, scheme.alphaF, scheme.beta, scheme.gamma);
}

} // namespace

PlaneSolid makeModel(const Case& structureCase) {
    try {
        return {structureCase.surface, structureCase.material, structureCase.strains,
                structureCase.supports, structureCase.loads};
    } catch (const InputError& error) {
        throw InputError(structureCase.file + ": " + error.what());
    }
}

std::string describeModel(const Case& structureCase, const PlaneSolid& solid) {
    const geometry::NurbsSurface& surface = solid.surface();
    const std::vector<bool>& fixed = solid.fixed();
    const Material& material = solid.material();
    const auto nFixed = std::count(fixed.begin(), fixed.end(), true);
    return fmt::format(
        "structure: {} ({})\n"
        "  {}, {} strains, degree {} x {}, {} x {} elements{}\n"
        "  {} unknowns, {} of them fixed\n"
        "  St. Venant-Kirchhoff: E {:g} Pa, nu {:g}, density {:g} kg/m^3, thickness {:g} m\n"
        "  Rayleigh damping: mass {:g} 1/s, stiffness {:g} s\n"
        "  time: {}\n",
        structureCase.name, structureCase.file,
        material.kinematics == Kinematics::planeStrain ? "plane strain" : "plane stress",
        solid.isLinear() ? "linear" : "nonlinear", surface.u().degree(), surface.v().degree(),
        surface.u().nSpans(), surface.v().nSpans(), surface.isRational() ? ", rational" : "",
        solid.nUnknowns(), nFixed, material.youngsModulus, material.poissonsRatio, material.density,
        material.thickness, material.massDamping, material.stiffnessDamping,
        describeScheme(structureCase.timeScheme));
}

} // namespace tokay::structure
