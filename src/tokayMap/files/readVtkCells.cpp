// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/readVtkCells.hpp"

#include "common/VtuFile.hpp"

#include <fmt/format.h>

namespace tokay::tool {

namespace {

/// Dimension of the cells of a type; -1 if it is not read.
int dimensionOf(VtkCell type) {
    switch (type) {
    case VtkCell::empty:
    case VtkCell::vertex:
    case VtkCell::polyVertex:
        return 0;
    case VtkCell::line:
    case VtkCell::polyLine:
        return 1;
    case VtkCell::triangle:
    case VtkCell::quadrilateral:
    case VtkCell::polygon:
    case VtkCell::pixel:
        return 2;
    default:
        return -1;
    }
}

std::vector<VtkCell> typesOf(const VtkArrays& arrays, pugi::xml_node cells, std::size_t n) {
    std::vector<VtkCell> types;
    for (const double number : arrays.numbers(arrays.arrayIn(cells, "types"), n)) {
        if (!(number >= 0 && number < 256)) {
            arrays.fail(fmt::format("cell {} has VTK's type {}, which does not exist", types.size(),
                                    number));
        }
        types.push_back(static_cast<VtkCell>(number));
    }
    return types;
}

class CellReader {
  public:
    CellReader(const VtkArrays& arrays, std::size_t nVertices)
        : arrays_(arrays), nVertices_(static_cast<double>(nVertices)) {}

    /// @param place  element with connectivity and offsets
    void add(pugi::xml_node place, const std::vector<VtkCell>& types) {
        if (types.empty()) {
            return;
        }
        const std::vector<double> ends =
            arrays_.numbers(arrays_.arrayIn(place, "offsets"), types.size());
        const std::vector<double> vertices =
            arrays_.numbers(arrays_.arrayIn(place, "connectivity"));
        double begin = 0;
        for (std::size_t i = 0; i < types.size(); ++i) {
            if (!(ends[i] >= begin && ends[i] <= static_cast<double>(vertices.size()))) {
                arrays_.fail(fmt::format("cell {} ends at {} of {} vertex numbers", cells_.size(),
                                         ends[i], vertices.size()));
            }
            addCell(types[i], {vertices.begin() + static_cast<long>(begin),
                               vertices.begin() + static_cast<long>(ends[i])});
            begin = ends[i];
        }
    }

    std::vector<MeshCell> take() { return std::move(cells_); }

  private:
    void addCell(VtkCell type, const std::vector<double>& vertices) {
        MeshCell cell{dimensionOf(type), {}};
        if (cell.dimension < 0) {
            arrays_.fail(fmt::format("cell {} has VTK's type {}, which is not supported: lines, "
                                     "triangles, quadrilaterals and polygons are; of a volume, "
                                     "extract the surface",
                                     cells_.size(), static_cast<int>(type)));
        }
        for (const double vertex : vertices) {
            if (!(vertex >= 0 && vertex < nVertices_)) {
                arrays_.fail(
                    fmt::format("cell {} names the point {}, but there are {} (indices start "
                                "at 0)",
                                cells_.size(), vertex, nVertices_));
            }
            cell.vertices.push_back(static_cast<int>(vertex));
        }
        if (type == VtkCell::pixel && cell.vertices.size() == 4) {
            std::swap(cell.vertices[2], cell.vertices[3]);
        }
        cells_.push_back(std::move(cell));
    }

    const VtkArrays& arrays_;
    double nVertices_;
    std::vector<MeshCell> cells_;
};

} // namespace

std::vector<MeshCell> readVtkCells(const VtkArrays& arrays, pugi::xml_node piece,
                                   std::size_t nVertices) {
    CellReader reader(arrays, nVertices);
    if (const pugi::xml_node cells = piece.child("Cells")) {
        reader.add(cells, typesOf(arrays, cells, arrays.count(piece, "NumberOfCells")));
    }
    const std::pair<const char*, VtkCell> kinds[] = {{"Verts", VtkCell::polyVertex},
                                                     {"Lines", VtkCell::polyLine},
                                                     {"Polys", VtkCell::polygon},
                                                     {"Strips", VtkCell::triangleStrip}};
    for (const auto& [kind, type] : kinds) {
        const std::size_t n = arrays.count(piece, (std::string("NumberOf") + kind).c_str());
        reader.add(piece.child(kind), std::vector<VtkCell>(n, type));
    }
    return reader.take();
}

} // namespace tokay::tool
