// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/SolidEntries.hpp"

#include "geometry/primitives/volumePrimitives.hpp"
#include "igaStructure/kinematics/solid/solidSupports.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

geometry::NurbsVolume makeVolume(const SolidEntries& entries) {
    const SolidModel& model = entries.model;
    if (!entries.geometry.isVolume()) {
        if (!model.thickness) {
            throw model.error("", "entry 'thickness' is missing: a solid given by its middle "
                                  "surface needs it");
        }
        return refined(entries.geometry.thickened(*model.thickness), entries.discretisation);
    }
    if (model.thickness) {
        throw model.error("thickness", "is not an option of a volume; allowed with a middle "
                                       "surface; remove it");
    }
    return refined(entries.geometry.volume(), entries.discretisation);
}

SolidLoads makeLoads(const std::vector<SolidLoad>& all) {
    SolidLoads loads;
    for (const SolidLoad& load : all) {
        if (load.traction.has_value() + load.pressure.has_value() + load.gravity.has_value() != 1) {
            throw load.error("", "give exactly one of: traction, pressure, gravity");
        }
        if (load.gravity.has_value() == load.face.has_value()) {
            throw load.error("", load.face ? "gravity acts on the whole body; remove face"
                                           : "entry 'face' is missing: traction and pressure "
                                             "act on one");
        }
        if (load.gravity) {
            loads.gravities.push_back(vectorField(*load.gravity));
        } else if (load.traction) {
            loads.tractions.push_back({*load.face, vectorField(*load.traction)});
        } else {
            loads.pressures.push_back({*load.face, scalarField(*load.pressure)});
        }
    }
    return loads;
}

} // namespace

geometry::NurbsVolume SolidGeometry::volume() const {
    return block ? block->volume() : nurbs->volume();
}

geometry::NurbsVolume SolidGeometry::thickened(double thickness) const {
    const auto make = [&](const auto& shape) {
        const geometry::NurbsSurface middle = shape.surface();
        return shape.at("", [&] { return geometry::thickened(middle, thickness); });
    };
    return rectangle ? make(*rectangle)
           : plate   ? make(*plate)
           : nurbs   ? make(*nurbs)
                     : make(*cylinder);
}

SolidDescription makeSolid(const SolidEntries& entries, const CaseContext&) {
    const geometry::NurbsVolume volume = makeVolume(entries);
    std::vector<SolidSupport> supports;
    for (const SolidSupportEntries& support : entries.supports) {
        support.at("faces", [&] { requireCommonPoints(volume, support.faces); });
        const std::array<bool, 3> fixed = fixedComponents<3>(support.fix);
        std::vector<std::string> names;
        for (const geometry::Side face : support.faces) {
            names.push_back(nameOf(face, faceChoices()));
        }
        supports.push_back({support.faces, fixed,
                            supportMotion(support, support.displacement, fixed),
                            fmt::format("{}", fmt::join(names, "-"))});
    }
    return {volume,   entries.material.material(), entries.model.strains,
            supports, makeLoads(entries.loads),    entries.geometry.isSlit};
}

} // namespace tokay::structure
