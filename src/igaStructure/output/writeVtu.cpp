#include "igaStructure/output/writeVtu.hpp"

#include "igaStructure/output/OutputFile.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

// Arrays announced in the XML part, whose bytes follow it.
class AppendedArrays {
  public:
    template <class Value>
    std::string announce(const char* type, const std::string& name, int nComponents,
                         std::vector<Value> values, const std::string& attributes = "") {
        const auto* bytes = reinterpret_cast<const char*>(values.data());
        const std::uint64_t size = values.size() * sizeof(Value);
        const std::uint64_t offset = data_.size();
        data_.append(reinterpret_cast<const char*>(&size), sizeof size);
        data_.append(bytes, size);
        return fmt::format("        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" {}"
                           "format=\"appended\" offset=\"{}\"/>\n",
                           type, name, nComponents, attributes, offset);
    }

    std::string announce(const std::string& name, const Eigen::MatrixXd& values) {
        const bool isTensor = values.rows() == 6;
        return announce("Float64", name, static_cast<int>(values.rows()),
                        std::vector<double>(values.data(), values.data() + values.size()),
                        isTensor ? tensorComponents : "");
    }

    const std::string& data() const { return data_; }

  private:
    static constexpr auto tensorComponents =
        "ComponentName0=\"XX\" ComponentName1=\"YY\" ComponentName2=\"ZZ\" "
        "ComponentName3=\"XY\" ComponentName4=\"YZ\" ComponentName5=\"XZ\" ";
    std::string data_;
};

std::string describeCells(const VtuMesh& mesh, std::size_t nCells, AppendedArrays& arrays) {
    std::vector<std::int64_t> ends(nCells);
    for (std::size_t k = 0; k < nCells; ++k) {
        ends[k] = static_cast<std::int64_t>(k + 1) * mesh.cellSize;
    }
    return "      <Cells>\n" + arrays.announce("Int64", "connectivity", 1, mesh.connectivity) +
           arrays.announce("Int64", "offsets", 1, ends) +
           arrays.announce("UInt8", "types", 1, std::vector<std::uint8_t>(nCells, mesh.cellType)) +
           "      </Cells>\n";
}

std::string describePointData(const VtuMesh& mesh, const std::vector<ResultField>& fields,
                              AppendedArrays& arrays) {
    std::string text = mesh.isBezier()
                           ? "      <PointData RationalWeights=\"RationalWeights\">\n" +
                                 arrays.announce("RationalWeights", mesh.weights.transpose())
                           : "      <PointData>\n";
    for (const ResultField& field : fields) {
        text += arrays.announce(field.name, fileValues(mesh, field.values));
    }
    return text + "      </PointData>\n";
}

std::string describeCellData(const VtuMesh& mesh, std::size_t nCells, AppendedArrays& arrays) {
    if (!mesh.isBezier()) {
        return "";
    }
    Eigen::MatrixXd degrees(3, nCells);
    degrees.colwise() = Eigen::Vector3d(mesh.degrees[0], mesh.degrees[1], 1);
    return "      <CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n" +
           arrays.announce("HigherOrderDegrees", degrees) + "      </CellData>\n";
}

std::string describePiece(const VtuPiece& piece, AppendedArrays& arrays) {
    const VtuMesh& mesh = piece.mesh;
    const std::size_t nCells = mesh.connectivity.size() / mesh.cellSize;
    std::string text = fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                                   mesh.points.size(), nCells);
    text += describePointData(mesh, piece.fields, arrays);
    text += describeCellData(mesh, nCells, arrays);
    text += "      <Points>\n" + arrays.announce("Points", fileValues(mesh, piece.positions)) +
            "      </Points>\n";
    return text + describeCells(mesh, nCells, arrays) + "    </Piece>\n";
}

} // namespace

void writeVtu(const std::string& path, const std::vector<VtuPiece>& pieces) {
    AppendedArrays arrays;
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                       "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                       "  <UnstructuredGrid>\n";
    for (const VtuPiece& piece : pieces) {
        text += describePiece(piece, arrays);
    }
    text += "  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
    OutputFile file(path);
    file.write(text);
    file.write(arrays.data());
    file.write("\n  </AppendedData>\n</VTKFile>\n");
    file.publish();
}

} // namespace tokay::structure
