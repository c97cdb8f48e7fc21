// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/writeField.hpp"

#include "common/VtuFile.hpp"

namespace tokay::tool {

namespace {

VtkCell cellType(std::size_t nVertices) {
    switch (nVertices) {
    case 1:
        return VtkCell::vertex;
    case 2:
        return VtkCell::line;
    case 3:
        return VtkCell::triangle;
    case 4:
        return VtkCell::quad;
    default:
        return VtkCell::polygon;
    }
}

std::vector<double> byRows(const Eigen::MatrixXd& values) {
    const Eigen::MatrixXd transposed = values.transpose();
    return {transposed.data(), transposed.data() + transposed.size()};
}

} // namespace

void writeField(const std::string& path, const FieldCells& cells, const std::string& name,
                const Eigen::MatrixXd& values) {
    std::vector<std::int64_t> connectivity, ends;
    std::vector<VtkCell> types;
    for (const std::vector<int>& cell : cells.cells) {
        connectivity.insert(connectivity.end(), cell.begin(), cell.end());
        ends.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(cellType(cell.size()));
    }
    VtuFile file;
    file.beginPiece({cells.vertices.data(), cells.vertices.data() + cells.vertices.size()},
                    connectivity, ends, types);
    const bool isOnVertices = cells.valuesAt == mapper::ValuesAt::vertices;
    file.addField(isOnVertices ? VtuFile::On::points : VtuFile::On::cells, name,
                  static_cast<int>(values.cols()), byRows(values));
    file.write(path);
}

} // namespace tokay::tool
