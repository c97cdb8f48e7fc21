// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/readSide.hpp"

#include "common/errors.hpp"
#include "tokayMap/files/readObj.hpp"
#include "tokayMap/files/readVtk.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace tokay::tool {

namespace {

using mapper::ValuesAt;

std::string ending(const std::string& path) {
    return std::filesystem::path(path).extension();
}

const char* placeName(ValuesAt at) {
    return at == ValuesAt::vertices ? "vertices" : "faces";
}

} // namespace

MeshFile readMesh(const std::string& path) {
    const std::string kind = ending(path);
    if (kind == ".vtu" || kind == ".vtp") {
        return readVtk(path);
    }
    if (kind == ".obj") {
        return readObj(path);
    }
    throw InputError(fmt::format("{}: files that end in '{}' cannot be read: .vtu, .vtp and "
                                 ".obj (meshes) and .json (cad.json, spline models) can",
                                 path, kind));
}

bool isSplineModel(const std::string& path) {
    return ending(path) == ".json";
}

std::unique_ptr<Side> readSide(const std::string& path, const SideOptions& options) {
    if (!options.edges.empty() && !isSplineModel(path)) {
        throw InputError(path +
                         ": only a spline model (cad.json) has edges to name; of a mesh, give "
                         "a file with its lines");
    }
    return isSplineModel(path) ? splineSide(path, options)
                               : meshSide(readMesh(path), path, options);
}

const MeshField& fieldNamed(const MeshFile& mesh, const std::string& path, const std::string& name,
                            std::optional<ValuesAt> at) {
    const MeshField* found = nullptr;
    for (const MeshField& field : mesh.fields) {
        if (field.name == name && (!at || field.at == *at) &&
            (!found || field.at == ValuesAt::faces)) {
            found = &field;
        }
    }
    if (!found) {
        throw InputError(fmt::format("{}: there is no field '{}'{}; there are:\n{}", path, name,
                                     at ? fmt::format(" at {}", placeName(*at)) : "",
                                     listFields(mesh)));
    }
    return *found;
}

std::string listFields(const MeshFile& mesh) {
    if (mesh.fields.empty()) {
        return "  no field\n";
    }
    std::string text;
    for (const MeshField& field : mesh.fields) {
        text += fmt::format("  {:<24} at {:<9} {} component{}, {:.4g} to {:.4g}\n", field.name,
                            placeName(field.at), field.values.cols(),
                            field.values.cols() == 1 ? "" : "s", field.values.minCoeff(),
                            field.values.maxCoeff());
    }
    return text;
}

} // namespace tokay::tool
