// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/files/MeshFile.hpp"

namespace tokay::tool {

/// Reads faces, or else lines, and the fields of a VTK file in XML: unstructured
/// grid (.vtu) or poly data (.vtp), all pieces one after the other. Cells of lower
/// dimension than the others are left out with their values.
/// @throws InputError naming file, array or cell for what is missing, inconsistent
/// or not supported (volume cells, quadratic cells, strips)
MeshFile readVtk(const std::string& path);

} // namespace tokay::tool
