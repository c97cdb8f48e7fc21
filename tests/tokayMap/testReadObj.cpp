// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "temporaryDirectory.hpp"
#include "tokayMap/files/readObj.hpp"

#include <gtest/gtest.h>

namespace tokay::tool {

namespace {

MeshFile read(const std::string& text) {
    const TemporaryDirectory directory;
    return readObj(directory.write("a.obj", text));
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5 1.0\n";

} // namespace

TEST(ReadObj, reads_polygons_in_every_notation) {
    const MeshFile mesh = read("# a square\no plate\n" + square +
                               "vt 0 0\nvn 0 0 1\nusemtl steel\r\nf 1 2 3 4 # all\n"
                               "f 1/1 2/1 3/1\nf 1//1 3//1 4//1\nf 1/1/1 2/1/1 4/1/1\n"
                               "f -4 -3 -1\n");
    EXPECT_FALSE(mesh.isLines);
    EXPECT_EQ(mesh.cells, (std::vector<std::vector<int>>{
                              {0, 1, 2, 3}, {0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {0, 1, 3}}));
    EXPECT_EQ(mesh.vertices.row(3), Eigen::RowVector3d(0, 1, 0.5));
}

TEST(ReadObj, reads_lines_where_there_is_no_face) {
    const MeshFile mesh = read(square + "l 1 2 3\n");
    EXPECT_TRUE(mesh.isLines);
    EXPECT_EQ(mesh.cells, (std::vector<std::vector<int>>{{0, 1}, {1, 2}}));
}

TEST(ReadObj, refuses_mistakes_with_their_line) {
    expectInputError([] { read(square + "f 1 2 5\n"); }, {"a.obj:5", "no vertex 5", "4 stand"});
    expectInputError([] { read(square + "f 1 2 0\n"); }, {"a.obj:5", "no vertex 0"});
    expectInputError([] { read(square + "f 1 2 -5\n"); }, {"a.obj:5", "no vertex -5"});
    expectInputError([] { read(square + "f 1 2\n"); }, {"a.obj:5", "at least three", "2"});
    expectInputError([] { read(square + "f 1 b 3\n"); }, {"a.obj:5", "'b'"});
    expectInputError([] { read("v 0 x 0\n"); }, {"a.obj:1", "three numbers"});
    expectInputError([] { read(square); }, {"a.obj", "neither a face nor a line"});
}

} // namespace tokay::tool
