// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "temporaryDirectory.hpp"
#include "tokayMap/files/readVtk.hpp"
#include "tokayMap/files/writeField.hpp"
#include "vtkText.hpp"

#include <gtest/gtest.h>

namespace tokay::tool {

namespace {

using Format = VtkStyle::Format;
using mapper::ValuesAt;

const MeshField& field(const MeshFile& mesh, const std::string& name) {
    for (const MeshField& candidate : mesh.fields) {
        if (candidate.name == name) {
            return candidate;
        }
    }
    throw std::runtime_error("no field " + name);
}

void expectExample(const MeshFile& mesh) {
    EXPECT_FALSE(mesh.isLines);
    EXPECT_EQ(mesh.cells, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(mesh.vertices.rows(), 4);
    EXPECT_EQ(mesh.vertices.row(2), Eigen::RowVector3d(1, 1, 0));
    EXPECT_EQ(field(mesh, "p").at, ValuesAt::vertices);
    EXPECT_EQ(field(mesh, "p").values, Eigen::Vector4d(0, 1, 1, 0));
    ASSERT_EQ(field(mesh, "U").values.cols(), 3);
    EXPECT_EQ(field(mesh, "U").values.row(3), Eigen::RowVector3d(0, 1, 0.25));
    EXPECT_EQ(field(mesh, "q").at, ValuesAt::faces);
    EXPECT_EQ(field(mesh, "q").values, Eigen::Vector2d(10, 20)) << "the line is left out";
}

MeshFile read(const std::string& text) {
    const TemporaryDirectory directory;
    return readVtk(directory.write("a.vtu", text));
}

void expectRefused(const std::string& text, const std::vector<std::string>& words) {
    expectInputError([&] { read(text); }, words);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) {
        throw std::runtime_error(from + " is not in the text");
    }
    return text.replace(at, from.size(), to);
}

} // namespace

TEST(ReadVtk, reads_every_format_with_every_header_and_type) {
    for (const Format format :
         {Format::ascii, Format::inlineBase64, Format::appendedRaw, Format::appendedBase64}) {
        for (const bool isCompressed : {false, true}) {
            for (const bool hasLongHeaders : {false, true}) {
                for (const bool isSingle : {false, true}) {
                    SCOPED_TRACE(testing::Message() << static_cast<int>(format) << isCompressed
                                                    << hasLongHeaders << isSingle);
                    expectExample(
                        read(exampleGrid({format, isCompressed, hasLongHeaders, isSingle})));
                }
            }
        }
    }
}

TEST(ReadVtk, reads_what_the_own_writer_writes) {
    const TemporaryDirectory directory;
    Points vertices(5, 3);
    vertices << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 1.0 / 3, 2;
    const std::vector<std::vector<int>> cells = {{0, 1, 4}, {1, 2, 3, 4}, {0, 1, 2, 3, 4}};
    const Eigen::MatrixXd values = Eigen::MatrixXd::Random(3, 3);
    writeField(directory.file("a.vtu"), {vertices, cells, ValuesAt::faces}, "f", values);
    const MeshFile mesh = readVtk(directory.file("a.vtu"));
    EXPECT_EQ(mesh.vertices, vertices);
    EXPECT_EQ(mesh.cells, cells);
    EXPECT_EQ(field(mesh, "f").values, values);
}

TEST(ReadVtk, reads_poly_data_of_several_pieces) {
    VtkText text(VtkStyle{Format::inlineBase64, false, true, true});
    std::string pieces = "<Piece NumberOfPoints=\"0\" NumberOfPolys=\"0\"/>\n";
    for (const double shift : {0.0, 2.0}) {
        pieces += "<Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"1\" "
                  "NumberOfPolys=\"1\">\n<Points>\n" +
                  text.reals("Points", 3, {shift, 0, 0, shift + 1, 0, 0, shift, 1, 0}) +
                  "</Points>\n<Lines>\n" + text.integers("connectivity", {0, 1}) +
                  text.integers("offsets", {2}) + "</Lines>\n<Polys>\n" +
                  text.integers("connectivity", {0, 1, 2}) + text.integers("offsets", {3}) +
                  "</Polys>\n<CellData>\n" + text.reals("p", 1, {-1, shift}) +
                  "</CellData>\n</Piece>\n";
    }
    const MeshFile mesh = read(text.file("PolyData", pieces));
    EXPECT_EQ(mesh.cells, (std::vector<std::vector<int>>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(mesh.vertices(4, 0), 3);
    EXPECT_EQ(field(mesh, "p").values, Eigen::Vector2d(0, 2));
}

TEST(ReadVtk, reads_lines_where_there_is_no_face) {
    VtkText text(VtkStyle{});
    const MeshFile mesh = read(text.file(
        "PolyData", "<Piece NumberOfPoints=\"3\" NumberOfLines=\"1\">\n<Points>\n" +
                        text.reals("Points", 3, {0, 0, 0, 1, 0, 0, 1, 1, 0}) +
                        "</Points>\n<Lines>\n" + text.integers("connectivity", {2, 1, 0}) +
                        text.integers("offsets", {3}) + "</Lines>\n<CellData>\n" +
                        text.reals("p", 1, {7}) + "</CellData>\n</Piece>\n"));
    EXPECT_TRUE(mesh.isLines);
    EXPECT_EQ(mesh.cells, (std::vector<std::vector<int>>{{2, 1}, {1, 0}}));
    EXPECT_EQ(field(mesh, "p").values, Eigen::Vector2d(7, 7)) << "both lines of the polyline";
}

TEST(ReadVtk, turns_the_vertices_of_a_pixel_into_a_quadrilateral) {
    VtkText text(VtkStyle{});
    const MeshFile mesh = read(text.file(
        "UnstructuredGrid",
        "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points>\n" +
            text.reals("Points", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}) + "</Points>\n<Cells>\n" +
            text.integers("connectivity", {0, 1, 2, 3}) + text.integers("offsets", {4}) +
            text.integers("types", {8}) + "</Cells>\n</Piece>\n"));
    EXPECT_EQ(mesh.cells, (std::vector<std::vector<int>>{{0, 1, 3, 2}}));
}

TEST(ReadVtk, refuses_what_it_does_not_support_by_name) {
    const std::string grid = exampleGrid({});
    expectRefused(replaced(grid, "LittleEndian", "BigEndian"), {"a.vtu", "BigEndian"});
    expectRefused(replaced(grid, "byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order"),
                  {"vtkLZ4DataCompressor", "zlib"});
    expectRefused(replaced(grid, "type=\"UnstructuredGrid\"", "type=\"ImageData\""),
                  {"ImageData", ".vtu"});
    expectRefused(replaced(grid, " 5 3 5", " 5 3 10"), {"cell 2", "type 10", "surface"});
    expectRefused("# vtk DataFile Version 3.0\n", {"a.vtu", "XML"});
    expectInputError([] { readVtk("/nowhere.vtu"); }, {"/nowhere.vtu", "cannot be opened"});
}

TEST(ReadVtk, refuses_damage_with_the_array_or_the_cell) {
    const std::string grid = exampleGrid({});
    expectRefused(replaced(grid, "0 1 2 0 1 0 2 3", "0 1 2 0 1 0 2 4"), {"cell 2", "point 4"});
    expectRefused(replaced(grid, " 10 30 20", " 10 30"), {"'q'", "2 numbers", "3"});
    expectRefused(replaced(grid, " 10 30 20", " 10 30 ab"), {"'q'", "ab"});
    expectRefused(replaced(grid, " 3 5 8", " 3 5 9"), {"cell 2", "9", "8"});
    expectRefused(replaced(grid, "Name=\"types\"", "Name=\"kinds\""), {"types"});
    expectRefused(grid.substr(0, grid.size() - 40), {"XML"});
    const std::string appended = exampleGrid({Format::appendedBase64});
    expectRefused(replaced(appended, "offset=\"0\"", "offset=\"99999\""), {"'p'", "99999"});
    expectRefused(appended.substr(0, appended.find("<AppendedData") + 80), {"array"});
}

TEST(ReadVtk, refuses_counts_that_the_file_cannot_hold) {
    const std::string grid = exampleGrid({});
    const std::string count = "NumberOfPoints=\"4\"";
    for (const char* const n : {"900000000", "6148914691236517206", "18446744073709551615"}) {
        expectRefused(replaced(grid, count, std::string("NumberOfPoints=\"") + n + "\""),
                      {"a.vtu", "NumberOfPoints", n, "bytes"});
    }
    VtkText text(VtkStyle{});
    const std::string triangle =
        "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"900000000\">\n<Points>\n" +
        text.reals("Points", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0}) + "</Points>\n<Polys>\n" +
        text.integers("connectivity", {0, 1, 2}) + text.integers("offsets", {3}) +
        "</Polys>\n</Piece>\n";
    expectRefused(text.file("PolyData", triangle), {"NumberOfPolys", "900000000", "bytes"});
    expectRefused(
        replaced(grid, "NumberOfComponents=\"3\"", "NumberOfComponents=\"9223372036854775808\""),
        {"NumberOfComponents", "9223372036854775808"});
}

TEST(ReadVtk, refuses_damaged_compressed_data) {
    std::string grid = exampleGrid({Format::appendedRaw, true, true, false});
    // The first array: number of blocks, sizes (4 headers of 8 bytes), then its block.
    const std::size_t block = grid.find(" _") + 2 + 4 * 8;
    grid[block + 4] = static_cast<char>(grid[block + 4] ^ 0x5a);
    expectRefused(grid, {"'p'", "damaged"});
    std::string huge = exampleGrid({Format::appendedRaw, true, true, false});
    huge[huge.find(" _") + 2 + 2 * 8 + 5] = 0x7f; // a size of the last block beyond any memory
    expectRefused(huge, {"'p'", "cannot grow"});
}

} // namespace tokay::tool
