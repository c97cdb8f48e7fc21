// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/writeField.hpp"

#include "common/VtuFile.hpp"

#include <cassert>

namespace tokay::tool {

namespace {

VtkCell cellType(std::size_t nVertices) {
    assert(nVertices > 0);
    constexpr VtkCell types[] = {VtkCell::vertex, VtkCell::line, VtkCell::triangle,
                                 VtkCell::quadrilateral};
    return nVertices <= std::size(types) ? types[nVertices - 1] : VtkCell::polygon;
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
