// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/VtuFile.hpp"

#include "common/OutputFile.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tokay {

namespace {

constexpr const char* vtkName(double) {
    return "Float64";
}
constexpr const char* vtkName(int) {
    return "Int32";
}
constexpr const char* vtkName(std::int64_t) {
    return "Int64";
}
constexpr const char* vtkName(VtkCell) {
    return "UInt8";
}

constexpr auto tensorComponents = "ComponentName0=\"XX\" ComponentName1=\"YY\" "
                                  "ComponentName2=\"ZZ\" ComponentName3=\"XY\" "
                                  "ComponentName4=\"YZ\" ComponentName5=\"XZ\" ";

std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) {
        text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return text;
}

std::string element(const char* name, const std::string& attributes, const std::string& content) {
    return fmt::format("<{0}{1}>\n{2}</{0}>\n", name, attributes, content);
}

} // namespace

template <class Value>
std::string VtuFile::append(const std::string& name, int nComponents,
                            const std::vector<Value>& values) {
    const std::uint64_t size = values.size() * sizeof(Value);
    const std::size_t offset = bytes_.size();
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" {}"
                       "format=\"appended\" offset=\"{}\"/>\n",
                       vtkName(Value()), escaped(name), nComponents,
                       nComponents == 6 ? tensorComponents : "", offset);
}

void VtuFile::beginPiece(const std::vector<double>& coordinates,
                         const std::vector<std::int64_t>& connectivity,
                         const std::vector<std::int64_t>& ends, const std::vector<VtkCell>& types) {
    Piece& piece = pieces_.emplace_back();
    piece.counts = fmt::format(" NumberOfPoints=\"{}\" NumberOfCells=\"{}\"",
                               coordinates.size() / 3, types.size());
    piece.points.arrays = append("Points", 3, coordinates);
    piece.cells.arrays = append("connectivity", 1, connectivity);
    piece.cells.arrays += append("offsets", 1, ends);
    piece.cells.arrays += append("types", 1, types);
}

void VtuFile::addField(On on, const std::string& name, int nComponents,
                       const std::vector<double>& values, const std::string& attribute) {
    section(on).arrays += append(name, nComponents, values);
    if (!attribute.empty()) {
        section(on).attributes += fmt::format(" {}=\"{}\"", attribute, escaped(name));
    }
}

void VtuFile::addField(On on, const std::string& name, const std::vector<int>& values) {
    section(on).arrays += append(name, 1, values);
}

void VtuFile::addTexts(const std::string& name, const std::vector<std::string>& texts) {
    std::vector<int> characters; // each text ends with a zero
    for (const std::string& text : texts) {
        for (const unsigned char c : text) {
            characters.push_back(c);
        }
        characters.push_back(0);
    }
    texts_ += fmt::format("<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" "
                          "format=\"ascii\">\n{}\n</DataArray>\n",
                          escaped(name), texts.size(), fmt::join(characters, " "));
}

std::string VtuFile::text(const Piece& piece) {
    std::string all;
    for (const auto& [name, section] :
         {std::pair<const char*, const Section&>{"PointData", piece.pointData},
          {"CellData", piece.cellData},
          {"Points", piece.points},
          {"Cells", piece.cells}}) {
        all += element(name, section.attributes, section.arrays);
    }
    return all;
}

void VtuFile::write(const std::string& path) const {
    std::string grid = texts_.empty() ? "" : element("FieldData", "", texts_);
    for (const Piece& piece : pieces_) {
        grid += element("Piece", piece.counts, text(piece));
    }
    OutputFile file(path);
    file.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n" +
               element("UnstructuredGrid", "", grid) + "<AppendedData encoding=\"raw\">\n_");
    file.write(bytes_);
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.publish();
}

} // namespace tokay
