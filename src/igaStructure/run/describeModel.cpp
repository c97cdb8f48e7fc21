// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/describeModel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

namespace {

std::string describe(const TimeScheme& scheme) {
    return scheme.dynamic
               ? fmt::format("implicit, alphaM {:.4g}, alphaF {:.4g}, beta {:.4g}, gamma {:.4g}",
                             scheme.alphaM, scheme.alphaF, scheme.beta, scheme.gamma)
               : "static";
}

std::string describe(const CentralDifferences&) {
    return "explicit, central differences, lumped mass";
}

std::string describe(const EquilibriumPath& path) {
    return fmt::format("arcLength: static, along the equilibrium path, at most {} steps, up "
                       "to {:g} times the first",
                       path.maxSteps, path.maxGrowth);
}

} // namespace

std::string describeModel(const Case& structureCase, const Body& body) {
    const StructuralModel& model = body.model();
    const std::vector<bool>& fixed = model.fixed();
    return fmt::format(
        "structure: {} ({})\n"
        "{}"
        "  {} unknowns, {} of them fixed\n"
        "  Rayleigh damping: mass {:g} 1/s, stiffness {:g} s\n"
        "  time: {}\n",
        structureCase.name, structureCase.file, body.description(), model.nUnknowns(),
        std::count(fixed.begin(), fixed.end(), true), model.massDamping(), model.stiffnessDamping(),
        std::visit([](const auto& scheme) { return describe(scheme); }, structureCase.timeScheme));
}

} // namespace tokay::structure
