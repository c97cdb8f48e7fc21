// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/readVolume.hpp"

#include "geometry/primitives/volumePrimitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"
#include "igaStructure/kinematics/readBrepModel.hpp"
#include "igaStructure/kinematics/readGeometry.hpp"

namespace tokay::structure {

namespace {

geometry::NurbsVolume readBlock(const CaseSection& section) {
    const std::vector<double> origin = section.numbers("origin");
    const std::vector<double> size = section.numbers("size");
    return geometry::block({origin[0], origin[1], origin[2]}, {size[0], size[1], size[2]});
}

geometry::NurbsVolume readNurbsVolume(const CaseSection& section) {
    const std::vector<int> degree = section.integers("degree", 3);
    section.require("knotsEta", "a volume has them");
    return {geometry::KnotVector(degree[0], section.numbers("knotsXi")),
            geometry::KnotVector(degree[1], section.numbers("knotsEta")),
            geometry::KnotVector(degree[2], section.numbers("knotsZeta")),
            readControlPoints(section), readWeights(section)};
}

geometry::NurbsVolume readThickened(const CaseSection& file, const std::string& shape) {
    const CaseSection model = file.section("model");
    model.require("thickness", "a solid given by its middle surface needs it");
    return geometry::thickened(readSpatialSurface(file.section("geometry"), shape),
                               model.number("thickness"));
}

geometry::NurbsVolume readUnrefined(const CaseSection& file) {
    const CaseSection section = file.section("geometry");
    const std::string shape =
        section.exactlyOne({"block", "rectangle", "plate", "cylinder", "nurbs"});
    const bool isVolume =
        shape == "block" || (shape == "nurbs" && section.section(shape).has("knotsZeta"));
    if (isVolume) {
        requireUsed(file.section("model"), {"kinematics", "strains"}, "a volume");
    }
    try {
        return shape == "block" ? readBlock(section.section(shape))
               : isVolume       ? readNurbsVolume(section.section(shape))
                                : readThickened(file, shape);
    } catch (const InputError& error) {
        throw section.error(shape, error.what());
    }
}

} // namespace

geometry::NurbsVolume readVolume(const CaseSection& file) {
    const geometry::NurbsVolume coarse = readUnrefined(file);
    const CaseSection section = file.section("discretisation");
    const std::vector<int> degree = section.integers("degree", 3);
    const std::vector<int> elements = section.integers("elements", 3);
    try {
        return geometry::refine(coarse, {degree[0], degree[1], degree[2]},
                                {elements[0], elements[1], elements[2]});
    } catch (const InputError& error) {
        throw section.error("degree", error.what());
    }
}

} // namespace tokay::structure
