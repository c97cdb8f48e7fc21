// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/readVtk.hpp"

#include "tokayMap/files/readVtkCells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tokay::tool {

namespace {

using mapper::ValuesAt;

class VtkReader {
  public:
    explicit VtkReader(const std::string& path) : arrays_(path) {}

    MeshFile read() {
        const std::string type = arrays_.root().attribute("type").as_string();
        if (type != "UnstructuredGrid" && type != "PolyData") {
            arrays_.fail(fmt::format("its type '{}' is not UnstructuredGrid (.vtu) or PolyData "
                                     "(.vtp)",
                                     type));
        }
        for (const pugi::xml_node piece : arrays_.root().child(type.c_str()).children("Piece")) {
            addPiece(piece);
        }
        return finished();
    }

  private:
    struct Values {
        std::size_t nComponents = 0;
        std::vector<double> values;
    };

    std::size_t nVertices() const { return coordinates_.size() / 3; }

    void addPiece(pugi::xml_node piece) {
        const std::size_t n = arrays_.count(piece, "NumberOfPoints");
        if (n == 0) {
            return;
        }
        const std::size_t firstVertex = nVertices(), firstCell = cells_.size();
        append(arrays_.numbers(arrays_.arrayIn(piece.child("Points")), 3 * n), coordinates_);
        for (MeshCell& cell : readVtkCells(arrays_, piece, n)) {
            for (int& vertex : cell.vertices) {
                vertex += static_cast<int>(firstVertex);
            }
            cells_.push_back(std::move(cell));
        }
        for (const pugi::xml_node array : piece.child("PointData").children("DataArray")) {
            addField(array, ValuesAt::vertices, firstVertex, n);
        }
        for (const pugi::xml_node array : piece.child("CellData").children("DataArray")) {
            addField(array, ValuesAt::faces, firstCell, cells_.size() - firstCell);
        }
    }

    static void append(const std::vector<double>& values, std::vector<double>& to) {
        to.insert(to.end(), values.begin(), values.end());
    }

    /// @param before  rows that the field must have from the pieces before
    void addField(pugi::xml_node array, ValuesAt at, std::size_t before, std::size_t n) {
        const std::string name = array.attribute("Name").as_string();
        const std::size_t nComponents = arrays_.count(array, "NumberOfComponents", 1);
        Values& field = fields_[{at, name}];
        if (before == 0) {
            field.nComponents = nComponents;
        }
        if (nComponents == 0 || field.nComponents != nComponents ||
            field.values.size() != before * nComponents) {
            arrays_.fail(fmt::format("the field '{}' is not the same in all pieces", name));
        }
        append(arrays_.numbers(array, n * nComponents), field.values);
    }

    MeshFile finished() {
        int dimension = 0;
        for (const MeshCell& cell : cells_) {
            dimension = std::max(dimension, cell.dimension);
        }
        if (dimension == 0) {
            arrays_.fail("there is neither a face nor a line in it");
        }
        MeshFile mesh;
        mesh.isLines = dimension == 1;
        mesh.vertices = Eigen::Map<const Points>(coordinates_.data(), nVertices(), 3);
        std::vector<int> rows; // of each cell of the mesh in the cell data
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i].dimension == dimension) {
                addCell(cells_[i].vertices, mesh);
                rows.resize(mesh.cells.size(), static_cast<int>(i));
            }
        }
        for (const auto& [key, values] : fields_) {
            mesh.fields.push_back(field(key.second, key.first, values, rows));
        }
        return mesh;
    }

    /// A polyline is several lines, each with its values.
    static void addCell(const std::vector<int>& vertices, MeshFile& mesh) {
        if (!mesh.isLines) {
            mesh.cells.push_back(vertices);
        } else {
            for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
                mesh.cells.push_back({vertices[i], vertices[i + 1]});
            }
        }
    }

    MeshField field(const std::string& name, ValuesAt at, const Values& values,
                    const std::vector<int>& rows) const {
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        const std::size_t n = at == ValuesAt::vertices ? nVertices() : cells_.size();
        if (values.values.size() != n * values.nComponents) {
            arrays_.fail(fmt::format("the field '{}' is not the same in all pieces", name));
        }
        const Eigen::Map<const Rows> all(values.values.data(), n, values.nComponents);
        if (at == ValuesAt::vertices) {
            return {name, at, all};
        }
        return {name, at, all(rows, Eigen::all)};
    }

    VtkArrays arrays_;
    std::vector<double> coordinates_;
    std::vector<MeshCell> cells_;
    std::map<std::pair<ValuesAt, std::string>, Values> fields_;
};

} // namespace

MeshFile readVtk(const std::string& path) {
    return VtkReader(path).read();
}

} // namespace tokay::tool
