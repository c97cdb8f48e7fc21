// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "mapper/conservation.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/interface/SurfaceMesh.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/sampleMeshes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::mapper {

namespace {

const FaceKind allKinds[] = {FaceKind::triangles, FaceKind::quadrilaterals, FaceKind::polygons};

} // namespace

TEST(SurfaceMesh, nearest_element_reproduces_linear_fields_and_conserves_forces) {
    for (const FaceKind kind : allKinds) {
        const SurfaceMesh mesh = flatMesh(7, 5, kind, ValuesAt::vertices);
        const Points to =
            flatMesh(11, 4, FaceKind::quadrilaterals, ValuesAt::vertices, 2, 1, 3).coordinates();
        const NearestElementMapping mapping(mesh, to);
        const Points mapped = mapping.apply(linearField(mesh.coordinates()));
        EXPECT_LT((mapped - linearField(to)).cwiseAbs().maxCoeff(), 1e-14 * 5);
        EXPECT_EQ(mapping.report().nUnmatched, 0);
        EXPECT_LT(mapping.report().rowSumError, 1e-14);
        expectForceAndMomentConserved(mapping, probeForces(to.rows()), mesh.coordinates(), to);
        expectTransposesEqual(mapping, mesh.nValues(), static_cast<int>(to.rows()));
    }
}

TEST(SurfaceMesh, face_values_are_constant_over_each_face) {
    const SurfaceMesh mesh = flatMesh(4, 4, FaceKind::quadrilaterals, ValuesAt::faces);
    EXPECT_EQ(mesh.nValues(), 16);
    const Location at = mesh.locate(mesh.coordinates().row(5));
    EXPECT_EQ(at.values, std::vector<int>{5});
    EXPECT_EQ(at.weights[0], 1);
}

TEST(SurfaceMesh, stretched_meshes_keep_the_linear_field) {
    // Anisotropy 1 : 1000; coordinates of the thin direction have 1e-13 of its size.
    const SurfaceMesh mesh = flatMesh(6, 6, FaceKind::triangles, ValuesAt::vertices, 1, 1e-3);
    const Points to =
        flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices, 1, 1e-3, 5).coordinates();
    const NearestElementMapping mapping(mesh, to);
    EXPECT_LT((mapping.apply(linearField(mesh.coordinates())) - linearField(to)).norm(), 1e-12);
}

TEST(SurfaceMesh, refuses_broken_faces_by_number) {
    Points vertices(5, 3);
    vertices << 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0, 0, 1, 0;
    const auto mesh = [&](const SurfaceMesh::Faces& faces) {
        SurfaceMesh(vertices, faces, ValuesAt::vertices);
    };
    expectInputError([&] { mesh({{0, 1, 3}, {0, 1}}); }, {"face 1", "2 vertices"});
    expectInputError([&] { mesh({{0, 1, 9}}); }, {"face 0", "vertex 9", "5"});
    expectInputError([&] { mesh({{0, 1, 3, 1}}); }, {"face 0", "vertex 1 twice"});
    expectInputError([&] { mesh({{0, 1, 3}, {0, 1, 2}}); }, {"face 1", "no area"});
    expectInputError([&] { mesh({}); }, {"no face"});
    vertices(3, 1) = INFINITY;
    expectInputError([&] { mesh({{0, 1, 3}}); }, {"point 3", "inf"});
}

TEST(SurfaceMesh, duplicate_points_make_a_face_without_area_and_are_refused) {
    Points vertices(4, 3);
    vertices << 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0;
    expectInputError(
        [&] {
            SurfaceMesh(vertices, {{0, 1, 3}, {0, 1, 2, 3}}, ValuesAt::vertices);
        },
        {"face 1", "no area", "vertices 1 and 2"});
}

TEST(SurfaceMesh, a_point_between_two_faces_as_near_is_ambiguous) {
    Points vertices(6, 3);
    vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1;
    const SurfaceMesh mesh(vertices, {{0, 1, 2}, {3, 4, 5}}, ValuesAt::vertices);
    EXPECT_TRUE(mesh.locate(Point(0.2, 0.2, 0.5)).ambiguous);
    EXPECT_FALSE(mesh.locate(Point(0.2, 0.2, 0.4)).ambiguous);
}

TEST(PointCloud, maps_the_nearest_value_and_conserves_the_sum) {
    const Points from = flatMesh(6, 6, FaceKind::triangles, ValuesAt::vertices).coordinates();
    const Points to =
        flatMesh(9, 9, FaceKind::triangles, ValuesAt::vertices, 2, 1, 2).coordinates();
    const NearestElementMapping mapping(PointCloud(from), to, {0.2});
    const Eigen::MatrixXd matrix = mapping.matrix();
    for (int i = 0; i < to.rows(); ++i) {
        Eigen::Index nearest, mapped;
        (from.rowwise() - to.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
        EXPECT_EQ(matrix.row(i).maxCoeff(&mapped), 1);
        EXPECT_EQ(mapped, nearest);
        EXPECT_EQ(matrix.row(i).sum(), 1);
    }
    EXPECT_LT(mapping.report().forceSumError, 1e-14);
    EXPECT_NE(mapping.report().text().find("nearest neighbour"), std::string::npos);
    expectTransposesEqual(mapping, static_cast<int>(from.rows()), static_cast<int>(to.rows()));
}

TEST(PointCloud, points_halfway_between_two_are_counted_as_ambiguous) {
    Points from(2, 3), to(2, 3);
    from << 0, 0, 0, 1, 0, 0;
    to << 0.5, 0, 0, 0.2, 0, 0;
    EXPECT_EQ(NearestElementMapping(PointCloud(from), to, {1}).report().nAmbiguous, 1);
}

TEST(SurfaceMesh, slivers_are_faces_as_long_as_they_are_more_than_rounding) {
    const auto sliver = [](double height) {
        Points vertices(3, 3);
        vertices << 0, 0, 0, 1, 0, 0, 0.5, height, 0;
        return SurfaceMesh(vertices, {{0, 1, 2}}, ValuesAt::vertices);
    };
    EXPECT_NO_THROW(sliver(1e-12));
    expectInputError([&] { sliver(1e-13); }, {"face 0", "no area"});
}

TEST(SurfaceMesh, size_is_the_diagonal_of_its_box) {
    const SurfaceMesh mesh = flatMesh(3, 3, FaceKind::triangles, ValuesAt::faces, 2, 1);
    EXPECT_NEAR(mesh.size(), std::hypot(2, 1), 1e-15);
}

} // namespace tokay::mapper
