#pragma once

#include "igaStructure/output/VtuMesh.hpp"

namespace tokay::structure {

/// Writes a .vtu file (XML, binary data appended).
/// @param positions  3 x nPoints, of the mesh's points [m]
/// @param fields     point data, values at the mesh's points
/// @throws OutputError
void writeVtu(const std::string& path, const VtuMesh& mesh, const Eigen::MatrixXd& positions,
              const std::vector<ResultField>& fields);

} // namespace tokay::structure
