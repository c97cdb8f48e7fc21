// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SurfaceMesh.hpp"

#include <string>
#include <vector>

namespace tokay::tool {

using geometry::Point;
using geometry::Points;

/// Values of a file at the vertices or on the cells of its mesh.
struct MeshField {
    std::string name;
    mapper::ValuesAt at;
    /// A row a vertex or cell, a column a component.
    Eigen::MatrixXd values;
};

/// A mesh of faces, or of lines if there is no face, with its fields.
struct MeshFile {
    Points vertices;
    /// Vertices of each face in order around it, or both ends of each line.
    std::vector<std::vector<int>> cells;
    bool isLines = false;
    std::vector<MeshField> fields;
};

} // namespace tokay::tool
