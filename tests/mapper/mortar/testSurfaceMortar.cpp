// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/conservation.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/sampleMeshes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace tokay::mapper {

namespace {

void expectPatchTest(const SurfaceMesh& from, const SurfaceMesh& to, MortarBasis basis) {
    MortarOptions options;
    options.basis = basis;
    const MortarMapping mapping(from, to, options);
    const Points expected = linearField(to.coordinates());
    const Points mapped = mapping.apply(linearField(from.coordinates()));
    EXPECT_LT((mapped - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
    EXPECT_LT(mapping.report().rowSumError, 1e-12);
    EXPECT_NEAR(mapping.report().coverage, 1, 1e-9);
    EXPECT_EQ(mapping.report().nUncovered, 0);
    expectForceAndMomentConserved(mapping, mapping.massMatrix() * probeForces(to.nValues()),
                                  from.coordinates(), to.coordinates());
    expectTransposesEqual(mapping, from.nValues(), to.nValues());
}

/// Rotated, scaled and moved.
SurfaceMesh placed(int n, int seed, double scale, double offset) {
    const SurfaceMesh mesh = flatMesh(n, n, FaceKind::triangles, ValuesAt::vertices, 2, 1, seed);
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(1.1, Point(1, 2, -1).normalized()).toRotationMatrix();
    const Points vertices = (scale * mesh.vertices() * rotation.transpose()).rowwise() +
                            scale * offset * Eigen::RowVector3d(1, -0.3, 0.2);
    SurfaceMesh::Faces faces;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = i + (n + 1) * j, b = a + 1, c = b + n + 1, d = a + n + 1;
            faces.push_back({a, b, c});
            faces.push_back({a, c, d});
        }
    }
    return SurfaceMesh(vertices, faces, ValuesAt::vertices);
}

/// Quarter of a cylinder of radius 1 and height 1, in facets.
SurfaceMesh quarterCylinder(int nAround, int nAlong, ValuesAt valuesAt) {
    Points vertices((nAround + 1) * (nAlong + 1), 3);
    SurfaceMesh::Faces faces;
    for (int j = 0; j <= nAlong; ++j) {
        for (int i = 0; i <= nAround; ++i) {
            const double angle = std::acos(0.0) * i / nAround;
            const int a = i + (nAround + 1) * j;
            vertices.row(a) << std::cos(angle), std::sin(angle), static_cast<double>(j) / nAlong;
            if (i < nAround && j < nAlong) {
                faces.push_back({a, a + 1, a + nAround + 2, a + nAround + 1});
            }
        }
    }
    return SurfaceMesh(vertices, faces, valuesAt);
}

} // namespace

TEST(SurfaceMortar, passes_the_patch_test_between_meshes_that_do_not_match) {
    for (const FaceKind kind :
         {FaceKind::triangles, FaceKind::quadrilaterals, FaceKind::polygons}) {
        const SurfaceMesh a = flatMesh(7, 5, kind, ValuesAt::vertices);
        const SurfaceMesh b = flatMesh(4, 6, FaceKind::triangles, ValuesAt::vertices, 2, 1, 3);
        expectPatchTest(a, b, MortarBasis::standard);
        expectPatchTest(b, a, MortarBasis::standard);
        expectPatchTest(a, b, MortarBasis::dual);
    }
}

TEST(SurfaceMortar, passes_the_patch_test_between_coarse_and_fine_meshes) {
    const SurfaceMesh coarse = flatMesh(1, 1, FaceKind::triangles, ValuesAt::vertices);
    const SurfaceMesh fine = flatMesh(100, 100, FaceKind::quadrilaterals, ValuesAt::vertices);
    expectPatchTest(coarse, fine, MortarBasis::standard);
    expectPatchTest(fine, coarse, MortarBasis::standard);
}

TEST(SurfaceMortar, matches_what_is_within_reach_of_a_destination_that_rises_from_the_source) {
    const SurfaceMesh from = flatMesh(7, 5, FaceKind::quadrilaterals, ValuesAt::vertices);
    const SurfaceMesh flat =
        flatMesh(20, 10, FaceKind::quadrilaterals, ValuesAt::vertices, 2, 1, 3);
    MortarOptions options;
    options.gapLimit.refuse = false;
    options.singular = SingularMass::minimumNorm; // one point may be all that a vertex has
    // The gap of half of the destination, 2 m long, is larger.
    const double slope = options.gapLimit.relative * from.size();
    Points risen = flat.vertices();
    risen.col(2) = slope * risen.col(0);
    SurfaceMesh::Faces faces;
    for (int i = 0; i < 200; ++i) {
        const int corner = i / 20 * 21 + i % 20;
        faces.push_back({corner, corner + 1, corner + 22, corner + 21});
    }
    const MortarMapping mapping(from, SurfaceMesh(risen, faces, ValuesAt::vertices), options);
    // A quadrature point stands for a sixth of a piece of the cells that the limit cuts, 0.1 m
    // long.
    EXPECT_NEAR(mapping.report().coverage, 0.5, 0.01);
    EXPECT_GT(mapping.report().largestGap, slope);
    const Eigen::VectorXd mapped = mapping.apply(Eigen::VectorXd::Ones(from.nValues()));
    for (Eigen::Index i = 0; i < mapped.size(); ++i) {
        // Cells are moved by a fifth of their length.
        if (risen(i, 0) < 0.8 || risen(i, 0) > 1.2) {
            EXPECT_NEAR(mapped[i], risen(i, 0) < 1 ? 1 : 0, 1e-10) << i;
        }
    }
}

TEST(SurfaceMortar, passes_the_patch_test_on_stretched_meshes) {
    const SurfaceMesh a = flatMesh(5, 6, FaceKind::triangles, ValuesAt::vertices, 1, 1e-3);
    const SurfaceMesh b = flatMesh(8, 3, FaceKind::triangles, ValuesAt::vertices, 1, 1e-3, 4);
    expectPatchTest(a, b, MortarBasis::standard);
}

TEST(SurfaceMortar, maps_constants_between_vertex_and_face_values) {
    for (const ValuesAt fromAt : {ValuesAt::vertices, ValuesAt::faces}) {
        for (const ValuesAt toAt : {ValuesAt::vertices, ValuesAt::faces}) {
            const SurfaceMesh from = flatMesh(6, 5, FaceKind::quadrilaterals, fromAt);
            const SurfaceMesh to = flatMesh(4, 7, FaceKind::polygons, toAt, 2, 1, 1);
            const MortarMapping mapping(from, to);
            EXPECT_LT(mapping.report().rowSumError, 1e-12);
            EXPECT_LT(mapping.report().forceSumError, 1e-12);
            expectTransposesEqual(mapping, from.nValues(), to.nValues());
        }
    }
}

TEST(SurfaceMortar, face_values_of_a_linear_field_are_its_means_over_the_faces) {
    const SurfaceMesh from = flatMesh(6, 5, FaceKind::triangles, ValuesAt::vertices);
    const SurfaceMesh to = flatMesh(4, 7, FaceKind::triangles, ValuesAt::faces, 2, 1, 1);
    const Points mapped = MortarMapping(from, to).apply(linearField(from.coordinates()));
    // The mean over a flat face is the value at its centroid.
    EXPECT_LT((mapped - linearField(to.coordinates())).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SurfaceMortar, scale_position_and_rotation_do_not_matter) {
    const Points values = probeForces(36);
    const Points reference = MortarMapping(placed(5, 0, 1, 0), placed(4, 2, 1, 0)).apply(values);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double offset : {0.0, 1e6}) {
            const Points mapped =
                MortarMapping(placed(5, 0, scale, offset), placed(4, 2, scale, offset))
                    .apply(values);
            // Coordinates of size 1e6 carry 1e-10 of the interface's size.
            EXPECT_LT((mapped - reference).cwiseAbs().maxCoeff(), offset > 0 ? 1e-8 : 1e-12)
                << scale << ", " << offset;
        }
    }
}

TEST(SurfaceMortar, keeps_constants_and_forces_between_faceted_sides_that_do_not_coincide) {
    const SurfaceMesh from = quarterCylinder(12, 5, ValuesAt::faces);
    const SurfaceMesh to = quarterCylinder(7, 4, ValuesAt::vertices);
    const MortarMapping mapping(from, to);
    EXPECT_LT(mapping.report().rowSumError, 1e-12);
    EXPECT_LT(mapping.report().forceSumError, 1e-12);
    EXPECT_GT(mapping.report().coverage, 0.999);
    EXPECT_LT(mapping.report().largestGap, 0.02); // sagitta of the coarser facets: 0.0063
    expectTransposesEqual(mapping, from.nValues(), to.nValues());
}

TEST(SurfaceMortar, a_wide_gap_limit_does_not_change_the_result) {
    const auto mappedWithin = [](const SurfaceMesh& from, const SurfaceMesh& to, double limit) {
        MortarOptions options;
        options.gapLimit.relative = limit;
        const MortarMapping mapping(from, to, options);
        EXPECT_EQ(mapping.report().nUncovered, 0);
        EXPECT_GT(mapping.report().coverage, 0.999);
        return Points(mapping.apply(probeForces(from.nValues())));
    };
    const std::pair<SurfaceMesh, SurfaceMesh> pairs[] = {
        {placed(9, 0, 1, 0), placed(7, 2, 1, 0)},
        {quarterCylinder(15, 6, ValuesAt::faces), quarterCylinder(11, 5, ValuesAt::vertices)},
        {quarterCylinder(11, 5, ValuesAt::vertices), quarterCylinder(40, 9, ValuesAt::vertices)}};
    for (const auto& [from, to] : pairs) {
        const Points narrow = mappedWithin(from, to, 0.01);
        // The same pieces in the same order: equal to rounding of the sums.
        for (const double limit : {0.1, 1.0}) {
            EXPECT_LT((mappedWithin(from, to, limit) - narrow).cwiseAbs().maxCoeff(), 1e-13);
        }
    }
}

TEST(SurfaceMortar, a_source_high_above_the_destination_is_found_along_its_normal) {
    // Rotated, the normal lies across all axes.
    const SurfaceMesh from = placed(9, 0, 1, 0), flat = placed(7, 2, 1, 0);
    const Point normal = flat.triangle(0).unitNormal();
    const double height = 0.09 * from.size();
    SurfaceMesh::Faces faces;
    for (int i = 0; i < flat.nTriangles(); ++i) {
        const std::array<int, 3> corners = flat.cornerNumbers(i);
        faces.push_back({corners[0], corners[1], corners[2]});
    }
    const SurfaceMesh above(flat.vertices().rowwise() + height * normal.transpose(), faces,
                            ValuesAt::vertices);
    MortarOptions options;
    options.gapLimit.relative = 0.1;
    const MortarMapping mapping(from, above, options), reference(from, flat, options);
    EXPECT_NEAR(mapping.report().coverage, 1, 1e-12);
    EXPECT_NEAR(mapping.report().largestGap, height, 1e-12);
    const Points values = probeForces(from.nValues());
    EXPECT_LT((mapping.apply(values) - reference.apply(values)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SurfaceMortar, a_thin_bodys_other_side_is_not_mapped) {
    // Two plates a hundredth apart, both within the gap limit of each other.
    const auto twoPlates = [](int n, double value, Points* values) {
        const SurfaceMesh plate = flatMesh(n, n, FaceKind::triangles, ValuesAt::vertices, 1, 1, n);
        const int nVertices = plate.nValues();
        Points vertices(2 * nVertices, 3);
        vertices << plate.vertices(), plate.vertices().rowwise() + Eigen::RowVector3d(0, 0, 0.01);
        SurfaceMesh::Faces faces;
        for (int copy = 0; copy < 2; ++copy) {
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    const int a = copy * nVertices + i + (n + 1) * j, c = a + n + 2;
                    faces.push_back({a, a + 1, c});
                    faces.push_back({a, c, a + n + 1});
                }
            }
        }
        if (values) {
            *values = Points::Zero(2 * nVertices, 3);
            values->bottomRows(nVertices).setConstant(value);
        }
        return SurfaceMesh(vertices, faces, ValuesAt::vertices);
    };
    Points values, expected;
    const SurfaceMesh from = twoPlates(6, 3, &values), to = twoPlates(5, 3, &expected);
    MortarOptions options;
    options.gapLimit.relative = 0.05;
    const MortarMapping mapping(from, to, options);
    EXPECT_LT((mapping.apply(values) - expected).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(mapping.report().coverage, 1, 1e-9);
}

TEST(SurfaceMortar, a_partly_covered_destination_takes_constants_and_counts_the_rest) {
    const SurfaceMesh from = flatMesh(6, 6, FaceKind::triangles, ValuesAt::vertices, 1, 1);
    const SurfaceMesh to = flatMesh(10, 5, FaceKind::triangles, ValuesAt::vertices, 2, 1);
    const MortarMapping mapping(from, to);
    EXPECT_NEAR(mapping.report().coverage, 0.5, 1e-12);
    EXPECT_GT(mapping.report().nUncovered, 0);
    const Eigen::VectorXd mapped = mapping.apply(Eigen::VectorXd::Ones(from.nValues()));
    int nZero = 0;
    for (const double value : mapped) {
        if (value == 0) {
            ++nZero;
        } else {
            EXPECT_NEAR(value, 1, 1e-9); // a sliver of a function is all it has
        }
    }
    EXPECT_EQ(nZero, mapping.report().nUncovered);
}

TEST(SurfaceMortar, a_thin_bodys_other_side_is_not_mapped_from_a_little_outside) {
    // Sides 0.01 apart with the values 0 and 3, the destination 0.002 outside them.
    const auto twoSheets = [](int n, double lower, double upper) {
        const SurfaceMesh sheet = flatMesh(n, n, FaceKind::triangles, ValuesAt::vertices, 1, 1, n);
        const int nVertices = sheet.nValues();
        Points vertices(2 * nVertices, 3);
        vertices << sheet.vertices(), sheet.vertices();
        vertices.topRows(nVertices).col(2).setConstant(lower);
        vertices.bottomRows(nVertices).col(2).setConstant(upper);
        SurfaceMesh::Faces faces;
        for (const int first : {0, nVertices}) {
            for (int i = 0; i < sheet.nTriangles(); ++i) {
                const std::array<int, 3> corners = sheet.cornerNumbers(i);
                faces.push_back({first + corners[0], first + corners[1], first + corners[2]});
            }
        }
        return SurfaceMesh(vertices, faces, ValuesAt::vertices);
    };
    const SurfaceMesh from = twoSheets(6, 0, 0.01), to = twoSheets(5, -0.002, 0.012);
    const auto values = [](const SurfaceMesh& mesh) {
        Eigen::VectorXd sides = Eigen::VectorXd::Zero(mesh.nValues());
        sides.tail(mesh.nValues() / 2).setConstant(3);
        return sides;
    };
    MortarOptions options;
    options.gapLimit.relative = 0.05;
    const MortarMapping mapping(from, to, options);
    EXPECT_LT((mapping.apply(values(from)) - values(to)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(mapping.massMatrix().sum(), 2, 1e-12);
    EXPECT_NEAR(mapping.report().largestGap, 0.002, 1e-12);
}

TEST(SurfaceMortar, mass_of_the_destination_is_the_same_whatever_the_source_holds) {
    const SurfaceMesh to = flatMesh(4, 5, FaceKind::polygons, ValuesAt::vertices, 2, 1, 3);
    const MortarMapping ofVertices(flatMesh(6, 5, FaceKind::triangles, ValuesAt::vertices), to);
    const MortarMapping ofFaces(flatMesh(6, 5, FaceKind::triangles, ValuesAt::faces), to);
    const Eigen::MatrixXd difference = ofFaces.massMatrix() - ofVertices.massMatrix();
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-15);
}

TEST(SurfaceMortar, the_side_that_faces_of_the_source_turn_to_does_not_matter) {
    const SurfaceMesh from = flatMesh(6, 5, FaceKind::triangles, ValuesAt::vertices);
    SurfaceMesh::Faces reversed;
    for (int i = 0; i < from.nTriangles(); ++i) {
        const std::array<int, 3> corners = from.cornerNumbers(i);
        reversed.push_back({corners[0], corners[2], corners[1]});
    }
    const SurfaceMesh other(from.vertices(), reversed, ValuesAt::vertices);
    const SurfaceMesh to = flatMesh(4, 7, FaceKind::triangles, ValuesAt::vertices, 2, 1, 1);
    const Points values = probeForces(from.nValues());
    EXPECT_LT((MortarMapping(other, to).apply(values) - MortarMapping(from, to).apply(values))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
}

TEST(SurfaceMortar, vertices_beyond_the_gap_limit_get_nothing_and_are_counted) {
    // The source rises from the destination by a tenth along x; the limit is 0.05 at x = 0.5.
    const SurfaceMesh to = flatMesh(8, 4, FaceKind::triangles, ValuesAt::vertices, 2, 1, 1);
    const SurfaceMesh flat = flatMesh(6, 5, FaceKind::triangles, ValuesAt::vertices);
    Points raised = flat.vertices();
    raised.col(2) = 0.1 * raised.col(0);
    SurfaceMesh::Faces faces;
    for (int i = 0; i < flat.nTriangles(); ++i) {
        const std::array<int, 3> corners = flat.cornerNumbers(i);
        faces.push_back({corners[0], corners[1], corners[2]});
    }
    const SurfaceMesh from(raised, faces, ValuesAt::vertices);
    MortarOptions options;
    options.gapLimit = {0.05 / from.size(), false};
    options.singular = SingularMass::minimumNorm;
    const MortarMapping mapping(from, to, options);
    const Eigen::VectorXd mapped = mapping.apply(Eigen::VectorXd::Ones(from.nValues()));
    int nBeyond = 0;
    for (int i = 0; i < to.nValues(); ++i) {
        nBeyond += mapped[i] == 0;
        if (to.coordinates()(i, 0) > 1) { // a cell and more beyond
            EXPECT_EQ(mapped[i], 0) << i;
        }
    }
    EXPECT_GT(nBeyond, 0);
    EXPECT_EQ(mapping.report().nUncovered, nBeyond);
    EXPECT_NEAR(mapping.report().coverage, 0.25, 0.02); // Gauss points on either side
}

} // namespace tokay::mapper
