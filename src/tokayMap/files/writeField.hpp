// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/files/MeshFile.hpp"

namespace tokay::tool {

/// Cells of one, two or more vertices with a field on them.
struct FieldCells {
    const Points& vertices;
    const std::vector<std::vector<int>>& cells;
    mapper::ValuesAt valuesAt;
};

/// Writes them for ParaView (.vtu).
/// @param values  a row a vertex or cell
/// @throws OutputError
void writeField(const std::string& path, const FieldCells& cells, const std::string& name,
                const Eigen::MatrixXd& values);

} // namespace tokay::tool
