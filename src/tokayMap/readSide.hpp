// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/Side.hpp"

#include <optional>

namespace tokay::tool {

/// Reads a mesh by the ending of its name: .vtu, .vtp or .obj.
/// @throws InputError if it is another one
MeshFile readMesh(const std::string& path);

/// True if the name is that of a spline model (.json).
bool isSplineModel(const std::string& path);

/// A mesh or a spline model.
std::unique_ptr<Side> readSide(const std::string& path, const SideOptions& options);

/// The field of a mesh with a name.
/// @param at  empty: wherever it is; if at both, on faces, as those at vertices
///            are interpolated in files of finite volumes
/// @throws InputError that lists the fields if there is none
const MeshField& fieldNamed(const MeshFile& mesh, const std::string& path, const std::string& name,
                            std::optional<mapper::ValuesAt> at);

/// Fields of a file, one a line: name, place, components, range.
std::string listFields(const MeshFile& mesh);

} // namespace tokay::tool
