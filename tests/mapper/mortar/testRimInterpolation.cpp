// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/expectPatchTest.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/mortar/rimVertices.hpp"
#include "mapper/sampleInterfaces.hpp"
#include "mapper/samplePatches.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tokay::mapper {

namespace {

MortarOptions interpolating(std::vector<int> values, MortarBasis basis = MortarBasis::standard) {
    MortarOptions options;
    options.basis = basis;
    options.interpolated = std::move(values);
    return options;
}

/// The ends of verticalMesh.
std::vector<int> endsOf(const CurveInterface& mesh) {
    std::vector<int> ends;
    for (int i = 0; i < mesh.nValues(); ++i) {
        const double y = mesh.coordinates()(i, 1);
        if (y == 0 || y == 1) {
            ends.push_back(i);
        }
    }
    return ends;
}

/// Control values that are 1 inside and 0 for the first two and the last two: a displacement
/// that rises within a span of clamped ends.
Eigen::VectorXd clampedField(int n) {
    Eigen::VectorXd field = Eigen::VectorXd::Ones(n);
    field.head(2).setZero();
    field.tail(2).setZero();
    return field;
}

} // namespace

TEST(RimInterpolation, ends_of_a_chain_of_edges_are_its_rim) {
    EXPECT_EQ(rimVertices({{0, 1}, {1, 2}, {3, 2}}), (std::vector<int>{0, 3}));
    EXPECT_TRUE(rimVertices({{0, 1}, {1, 2}, {2, 0}}).empty());
}

TEST(RimInterpolation, vertices_of_sides_of_one_face_are_the_rim_of_a_surface) {
    // 2 x 2 quadrilaterals around the vertex 4
    EXPECT_EQ(rimVertices({{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}}),
              (std::vector<int>{0, 1, 2, 3, 5, 6, 7, 8}));
    EXPECT_TRUE(rimVertices({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}).empty()) << "tetrahedron";
}

TEST(RimInterpolation, a_clamped_end_stays_where_the_projection_moves_it) {
    const SplineInterface from = verticalSpline(3, 32);
    const CurveInterface to = verticalMesh(4);
    const Eigen::VectorXd field = clampedField(from.nValues());
    for (const MortarBasis basis : {MortarBasis::standard, MortarBasis::dual}) {
        const MortarMapping free(from, to, interpolating({}, basis)),
            given(from, to, interpolating(endsOf(to), basis));
        for (const int end : endsOf(to)) {
            EXPECT_GT(free.apply(field)(end, 0), 0.5);
            EXPECT_NEAR(given.apply(field)(end, 0), 0, 1e-14);
        }
    }
}

TEST(RimInterpolation, the_other_values_are_the_best_with_those_of_the_rim_given) {
    const SplineInterface from = verticalSpline(3, 7);
    const CurveInterface to = verticalMesh(5);
    const std::vector<int> ends = endsOf(to);
    const MortarMapping free(from, to), given(from, to, interpolating(ends));
    const Points values = probeForces(from.nValues());
    // The residual of the projection vanishes against every function but the ends'
    Points residual = free.crossMatrix() * values - free.massMatrix() * given.apply(values);
    double atEnds = 0;
    for (const int end : ends) {
        atEnds += residual.row(end).norm();
        residual.row(end).setZero();
    }
    EXPECT_LT(residual.norm(), 1e-13 * (free.crossMatrix() * values).norm());
    EXPECT_GT(atEnds, 1e-3 * (free.crossMatrix() * values).norm());
}

TEST(RimInterpolation, linear_fields_forces_and_moments_are_kept) {
    const SplineInterface spline = verticalSpline(3, 7);
    const CurveInterface line = verticalMesh(5);
    for (const MortarBasis basis : {MortarBasis::standard, MortarBasis::dual}) {
        expectPatchTest(spline, line, interpolating(endsOf(line), basis));
    }
}

TEST(RimInterpolation, a_surface_keeps_its_clamped_edges) {
    const SurfaceInterface from = onePatch(geometry::TrimmedPatch(plate(16, 8)));
    Points vertices(20, 3); // 4 x 3 faces on the plate [0, 2] x [0, 1]
    SurfaceMesh::Faces faces;
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 5; ++i) {
            vertices.row(i + 5 * j) << 0.5 * i, j / 3.0, 0;
            if (i < 4 && j < 3) {
                const int k = i + 5 * j;
                faces.push_back({k, k + 1, k + 6, k + 5});
            }
        }
    }
    const std::vector<int> rim = rimVertices(faces);
    ASSERT_EQ(rim.size(), 14u);
    const SurfaceMesh to(vertices, faces, ValuesAt::vertices);
    for (const MortarBasis basis : {MortarBasis::standard, MortarBasis::dual}) {
        expectPatchTest(from, to, interpolating(rim, basis));
        Eigen::VectorXd field = Eigen::VectorXd::Zero(from.nValues());
        for (int k = 0; k < from.nValues(); ++k) {
            const double x = from.coordinates()(k, 0), y = from.coordinates()(k, 1);
            field[k] = x > 0 && x < 2 && y > 0 && y < 1 ? 1 : 0;
        }
        const Eigen::VectorXd mapped =
            MortarMapping(from, to, interpolating(rim, basis)).apply(field);
        for (const int vertex : rim) {
            EXPECT_NEAR(mapped[vertex], 0, 1e-13);
        }
        EXPECT_GT(mapped.maxCoeff(), 0.9);
    }
}

} // namespace tokay::mapper
