// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/files/MeshFile.hpp"

namespace tokay::tool {

/// Reads vertices and faces, or else lines, of a Wavefront file (.obj); texture,
/// normals, groups and materials are passed over. It has no fields.
/// @throws InputError with file and line
MeshFile readObj(const std::string& path);

} // namespace tokay::tool
