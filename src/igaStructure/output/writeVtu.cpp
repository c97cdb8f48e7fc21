// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/output/writeVtu.hpp"

namespace tokay::structure {

namespace {

void addPointField(const std::string& name, const Eigen::MatrixXd& values, VtuFile& file,
                   const std::string& attribute = "") {
    file.addField(VtuFile::On::points, name, static_cast<int>(values.rows()),
                  {values.data(), values.data() + values.size()}, attribute);
}

void addBezierData(const VtuMesh& mesh, std::size_t nCells, VtuFile& file) {
    addPointField("RationalWeights", mesh.weights.transpose(), file, "RationalWeights");
    Eigen::MatrixXd degrees(3, nCells);
    degrees.colwise() = mesh.degrees.cwiseMax(1).cast<double>();
    file.addField(VtuFile::On::cells, "HigherOrderDegrees", 3,
                  {degrees.data(), degrees.data() + degrees.size()}, "HigherOrderDegrees");
}

void addPiece(const VtuPiece& piece, VtuFile& file) {
    const VtuMesh& mesh = piece.mesh;
    const std::size_t nCells = mesh.connectivity.size() / mesh.cellSize;
    std::vector<std::int64_t> ends(nCells);
    for (std::size_t k = 0; k < nCells; ++k) {
        ends[k] = static_cast<std::int64_t>(k + 1) * mesh.cellSize;
    }
    const Eigen::MatrixXd points = fileValues(mesh, piece.positions);
    file.beginPiece({points.data(), points.data() + points.size()}, mesh.connectivity, ends,
                    std::vector<VtkCell>(nCells, mesh.cellType));
    if (mesh.isBezier()) {
        addBezierData(mesh, nCells, file);
    }
    for (const ResultField& field : piece.fields) {
        addPointField(field.name, fileValues(mesh, field.values), file);
    }
}

} // namespace

void writeVtu(const std::string& path, const std::vector<VtuPiece>& pieces) {
    VtuFile file;
    for (const VtuPiece& piece : pieces) {
        addPiece(piece, file);
    }
    file.write(path);
}

} // namespace tokay::structure
