// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/readBrepModel.hpp"

#include "geometry/brep/cadJson.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/kinematics/readGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace tokay::structure {

namespace {

geometry::Point readPoint(const CaseSection& section, const std::string& name) {
    const std::vector<double> values = section.numbers(name);
    return {values[0], values[1], values[2]};
}

geometry::NurbsSurface readPlate(const CaseSection& section) {
    return geometry::plate(readPoint(section, "origin"), readPoint(section, "edgeXi"),
                           readPoint(section, "edgeEta"));
}

geometry::NurbsSurface readCylinder(const CaseSection& section) {
    const std::vector<double> angles = section.numbers("angles");
    constexpr double degree = M_PI / 180;
    return geometry::cylinderPatch(readPoint(section, "base"), section.number("radius"),
                                   section.number("height"), degree * angles[0],
                                   degree * angles[1]);
}

constexpr double sameEdge = 1e-6; // of the size: coordinates of a file have some digits only

// A patch with its edges: a closed one is joined to itself along its seam.
geometry::BrepModel wholeSurface(const geometry::NurbsSurface& surface, bool isSlit) {
    const std::vector<geometry::BrepFace> faces = {{geometry::TrimmedPatch(surface, "shell")}};
    const geometry::BrepModel alone(faces);
    constexpr double never = -1;
    std::vector<geometry::BrepEdge> edges =
        geometry::coincidentEdges(faces, isSlit ? never : sameEdge * alone.size());
    for (geometry::BrepEdge& edge : edges) {
        edge.isFound = edge.trims.size() > 1;
    }
    return geometry::BrepModel(faces, std::move(edges));
}

geometry::BrepModel readUnrefined(const CaseSection& section, const std::string& directory) {
    const std::string shape =
        section.exactlyOne({"rectangle", "plate", "cylinder", "nurbs", "cadJson"});
    const bool isSlit = section.yesNo("slit");
    if (shape != "cadJson") {
        return wholeSurface(readSpatialSurface(section, shape), isSlit);
    }
    const std::string path = (std::filesystem::path(directory) / section.text(shape)).string();
    geometry::BrepModel model = geometry::readCadJson(path);
    return isSlit ? model
                  : geometry::withCoincidentEdges(
                        model, std::max(model.tolerance(), sameEdge * model.size()));
}

} // namespace

geometry::NurbsSurface readSpatialSurface(const CaseSection& section, const std::string& shape) {
    try {
        return shape == "plate"      ? readPlate(section.section(shape))
               : shape == "cylinder" ? readCylinder(section.section(shape))
                                     : readUnrefinedSurface(section);
    } catch (const InputError& error) {
        throw section.error(shape, error.what());
    }
}

geometry::BrepModel readBrepModel(const CaseSection& file, const std::string& directory) {
    const geometry::BrepModel model = readUnrefined(file.section("geometry"), directory);
    const CaseSection section = file.section("discretisation");
    const std::vector<int> degree = section.integers("degree", 2);
    const std::vector<int> elements = section.integers("elements", 2);
    try {
        return model.refined(degree[0], degree[1], elements[0], elements[1]);
    } catch (const InputError& error) {
        throw section.error("degree", error.what());
    }
}

} // namespace tokay::structure
