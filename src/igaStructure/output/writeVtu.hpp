// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/output/ResultField.hpp"
#include "igaStructure/output/VtuMesh.hpp"

namespace tokay::structure {

/// A mesh of a .vtu file with its data.
struct VtuPiece {
    const VtuMesh& mesh;
    Eigen::MatrixXd positions;       ///< 3 x nPoints, of the mesh's points [m]
    std::vector<ResultField> fields; ///< point data, values at the mesh's points
};

/// Writes a .vtu file (XML, binary data appended).
/// @param pieces  with the same fields
/// @throws OutputError
void writeVtu(const std::string& path, const std::vector<VtuPiece>& pieces);

} // namespace tokay::structure
