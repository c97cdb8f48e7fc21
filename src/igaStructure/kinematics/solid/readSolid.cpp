// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/readSolid.hpp"

#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"
#include "igaStructure/kinematics/readGeometry.hpp"
#include "igaStructure/kinematics/readMaterial.hpp"
#include "igaStructure/kinematics/solid/readVolume.hpp"

#include <algorithm>

namespace tokay::structure {

namespace {

std::vector<SolidSupport> readSolidSupports(const CaseSection& file) {
    std::vector<SolidSupport> supports;
    for (const CaseSection& section : file.list("supports")) {
        requireUsed(section, {"faces", "fix"}, "a solid");
        section.require("faces", "a solid is held there");
        SolidSupport support;
        for (const std::string& face : section.words("faces")) {
            support.sides.push_back(geometry::sideFromName(face));
        }
        for (const std::string& component : section.words("fix", {"x", "y", "z"}, "a solid")) {
            support.fixed[component[0] - 'x'] = true;
        }
        supports.push_back(std::move(support));
    }
    return supports;
}

geometry::Side readSide(const CaseSection& section) {
    section.require("face", "tractions and pressures of a solid act on one");
    try {
        return geometry::sideFromName(section.text("face"));
    } catch (const InputError& error) {
        throw section.error("face", error.what());
    }
}

SolidLoads readSolidLoads(const CaseSection& file) {
    SolidLoads loads;
    for (const CaseSection& section : file.list("loads")) {
        requireUsed(section, {"face", "traction", "pressure", "gravity"}, "a solid");
        if (section.has("traction") + section.has("pressure") + section.has("gravity") != 1) {
            throw section.error("", "give exactly one of: traction, pressure, gravity");
        }
        if (section.has("gravity")) {
            requireUsed(section, {"gravity"}, "gravity");
            loads.gravities.push_back(readVectorField(section, "gravity"));
        } else if (section.has("traction")) {
            loads.tractions.push_back({readSide(section), readVectorField(section, "traction")});
        } else {
            loads.pressures.push_back({readSide(section), readScalarField(section, "pressure")});
        }
    }
    return loads;
}

} // namespace

SolidDescription readSolid(const CaseSection& file) {
    const CaseSection model = file.section("model");
    requireUsed(model, {"kinematics", "strains", "thickness"}, "solid");
    return {readVolume(file),
            readMaterial(file),
            model.text("strains") == "linear" ? Strains::linear : Strains::nonlinear,
            readSolidSupports(file),
            readSolidLoads(file),
            isSlit(file)};
}

} // namespace tokay::structure
