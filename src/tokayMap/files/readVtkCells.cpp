// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/readVtkCells.hpp"

#include <fmt/format.h>

#include <map>

namespace tokay::tool {

namespace {

/// VTK's numbers of those cells that are read.
enum CellType { polyVertex = 2, polyLine = 4, triangleStrip = 6, polygon = 7, pixel = 8 };

/// -1 for a type that is not read.
int dimensionOf(int type) {
    static const std::map<int, int> dimensions = {
        {0, 0}, {1, 0}, {polyVertex, 0}, {3, 1},     {polyLine, 1},
        {5, 2}, {9, 2}, {polygon, 2},    {pixel, 2},
    };
    const auto found = dimensions.find(type);
    return found == dimensions.end() ? -1 : found->second;
}

class CellReader {
  public:
    CellReader(const VtkArrays& arrays, std::size_t nVertices)
        : arrays_(arrays), nVertices_(static_cast<double>(nVertices)) {}

    /// @param place  element with connectivity and offsets
    void add(pugi::xml_node place, const std::vector<double>& types) {
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
            addCell(static_cast<int>(types[i]), {vertices.begin() + static_cast<long>(begin),
                                                 vertices.begin() + static_cast<long>(ends[i])});
            begin = ends[i];
        }
    }

    std::vector<VtkCell> take() { return std::move(cells_); }

  private:
    void addCell(int type, const std::vector<double>& vertices) {
        VtkCell cell{dimensionOf(type), {}};
        if (cell.dimension < 0) {
            arrays_.fail(fmt::format("cell {} has VTK's type {}, which is not supported: lines, "
                                     "triangles, quadrilaterals and polygons are; of a volume, "
                                     "extract the surface",
                                     cells_.size(), type));
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
        if (type == pixel && cell.vertices.size() == 4) {
            std::swap(cell.vertices[2], cell.vertices[3]);
        }
        cells_.push_back(std::move(cell));
    }

    const VtkArrays& arrays_;
    double nVertices_;
    std::vector<VtkCell> cells_;
};

} // namespace

std::vector<VtkCell> readVtkCells(const VtkArrays& arrays, pugi::xml_node piece,
                                  std::size_t nVertices) {
    CellReader reader(arrays, nVertices);
    if (const pugi::xml_node cells = piece.child("Cells")) {
        reader.add(cells, arrays.numbers(arrays.arrayIn(cells, "types"),
                                         piece.attribute("NumberOfCells").as_ullong()));
    }
    const std::pair<const char*, int> kinds[] = {
        {"Verts", polyVertex}, {"Lines", polyLine}, {"Polys", polygon}, {"Strips", triangleStrip}};
    for (const auto& [kind, type] : kinds) {
        const std::string count = std::string("NumberOf") + kind;
        const std::size_t n = piece.attribute(count.c_str()).as_ullong();
        reader.add(piece.child(kind), std::vector<double>(n, type));
    }
    return reader.take();
}

} // namespace tokay::tool
