// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/files/VtkArrays.hpp"

namespace tokay::tool {

/// Cell of a file.
struct MeshCell {
    /// Dimension: 0 points, 1 line, 2 face.
    int dimension;
    std::vector<int> vertices;
};

/// Cells of a piece of an unstructured grid or of poly data, in the order in
/// which VTK numbers their values.
/// @throws InputError naming the first cell that is not supported or names a
/// vertex that does not exist
std::vector<MeshCell> readVtkCells(const VtkArrays& arrays, pugi::xml_node piece,
                                   std::size_t nVertices);

} // namespace tokay::tool
