// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/describeModel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

namespace {

std::string describeScheme(const Case& structureCase) {
    const TimeScheme& scheme = structureCase.timeScheme;
    if (structureCase.timeSteps && structureCase.timeSteps->isExplicit) {
        return "explicit, central differences, lumped mass";
    }
    if (!scheme.dynamic) {
        return "static";
    }
    return fmt::format("implicit, alphaM {:.4g}, alphaF {:.4g}, beta {:.4g}, gamma {:.4g}",
                       scheme.alphaM, scheme.alphaF, scheme.beta, scheme.gamma);
}

} // namespace

std::string describeModel(const Case& structureCase, const Body& body) {
    const StructuralModel& model = body.model();
    const std::vector<bool>& fixed = model.fixed();
    return fmt::format("structure: {} ({})\n"
                       "{}"
                       "  {} unknowns, {} of them fixed\n"
                       "  Rayleigh damping: mass {:g} 1/s, stiffness {:g} s\n"
                       "  time: {}\n",
                       structureCase.name, structureCase.file, body.description(),
                       model.nUnknowns(), std::count(fixed.begin(), fixed.end(), true),
                       model.massDamping(), model.stiffnessDamping(),
                       describeScheme(structureCase));
}

} // namespace tokay::structure
