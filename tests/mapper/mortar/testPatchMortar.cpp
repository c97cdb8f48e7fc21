// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/conservation.hpp"
#include "mapper/expectPatchTest.hpp"
#include "mapper/intersection/patchIntersection.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/sampleMeshes.hpp"
#include "mapper/samplePatches.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace tokay::mapper {

namespace {

const double pi = std::acos(-1.0);
using geometry::NurbsSurface;
using geometry::TrimmedPatch;

} // namespace

TEST(PatchMortar, passes_the_patch_test_between_meshes_and_a_patch_both_ways) {
    for (const FaceKind kind :
         {FaceKind::triangles, FaceKind::quadrilaterals, FaceKind::polygons}) {
        const SurfaceMesh mesh = flatMesh(9, 7, kind, ValuesAt::vertices);
        expectPatchTest(mesh, onePatch(TrimmedPatch(plate(5, 4))));
        expectPatchTest(onePatch(TrimmedPatch(plate(5, 4))), mesh);
    }
}

TEST(PatchMortar, covers_a_flat_interface_completely) {
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::quadrilaterals, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(plate(5, 4)));
    EXPECT_NEAR(MortarMapping(mesh, splines).report().coverage, 1, 1e-12);
    EXPECT_NEAR(MortarMapping(splines, mesh).report().coverage, 1, 1e-12);
    EXPECT_EQ(MortarMapping(splines, mesh).report().nUncovered, 0);
    // The integral of all functions of the patch is its area.
    const MortarMapping mapping(mesh, splines);
    EXPECT_NEAR(mapping.massMatrix().sum(), 2, 1e-13);
    EXPECT_NEAR(mapping.crossMatrix().sum(), 2, 1e-13);
}

TEST(PatchMortar, passes_the_patch_test_with_parameters_that_are_neither_straight_nor_even) {
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(bentParameters(6, 4)));
    expectPatchTest(mesh, splines);
    expectPatchTest(splines, mesh);
}

TEST(PatchMortar, passes_the_patch_test_on_a_trimmed_patch) {
    MortarOptions options;
    options.singular = SingularMass::minimumNorm;
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices);
    expectPatchTest(mesh, onePatch(holedPlate()), options);
    expectPatchTest(onePatch(holedPlate()), mesh, options);
    const MortarMapping mapping(mesh, onePatch(holedPlate()), options);
    // In space the hole is an ellipse of semi-axes 2 * 0.23 and 0.23.
    EXPECT_NEAR(mapping.massMatrix().sum(), 2 - pi * 2 * 0.23 * 0.23, 1e-4);
}

TEST(PatchMortar, passes_the_patch_test_across_patches) {
    const SurfaceMesh mesh = flatMesh(8, 5, FaceKind::quadrilaterals, ValuesAt::vertices);
    expectPatchTest(mesh, twoPatches());
    expectPatchTest(twoPatches(), mesh);
    EXPECT_NEAR(MortarMapping(twoPatches(), mesh).report().coverage, 1, 1e-12);
}

TEST(PatchMortar, faces_partly_outside_are_cut_at_the_edge_of_the_patch) {
    // The mesh reaches from x = 0 to 2, the patch only to 1.
    const NurbsSurface half = refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 3, 3);
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(half));
    expectPatchTest(mesh, splines);
    EXPECT_NEAR(MortarMapping(mesh, splines).massMatrix().sum(), 1, 1e-13);
    const MortarMapping back(splines, mesh);
    EXPECT_NEAR(back.massMatrix().sum(), 1, 1e-13);
    EXPECT_NEAR(back.report().coverage, 0.5, 1e-12);
    EXPECT_GT(back.report().nUncovered, 0);
}

TEST(PatchMortar, faces_over_the_seam_of_a_cylinder_are_mapped_once) {
    // Facets turned against the seam, so that a row of them lies over it.
    const NurbsSurface cylinder =
        refine(geometry::cylinderPatch(Point::Zero(), 1, 1, 0, 2 * pi), 2, 2, 2, 2);
    for (const int nAround : {24, 48}) {
        Points vertices(2 * nAround, 3);
        SurfaceMesh::Faces faces;
        for (int i = 0; i < nAround; ++i) {
            const double angle = 2 * pi * (i + 0.4) / nAround;
            vertices.row(i) << std::cos(angle), std::sin(angle), 0;
            vertices.row(nAround + i) << std::cos(angle), std::sin(angle), 1;
            const int next = (i + 1) % nAround;
            faces.push_back({i, next, nAround + next, nAround + i});
        }
        const SurfaceMesh mesh(vertices, faces, ValuesAt::vertices);
        const MortarMapping mapping(mesh, onePatch(TrimmedPatch(cylinder)));
        // Pieces are of polygons in parameter space that together fill it: only
        // the rule of degree 4 on the rational Jacobian is left.
        EXPECT_NEAR(mapping.massMatrix().sum(), 2 * pi, 1e-6);
        EXPECT_NEAR(mapping.report().coverage, 1, 1e-6);
        EXPECT_LT(mapping.report().rowSumError, 1e-12);
        EXPECT_LT(mapping.report().forceSumError, 1e-12);
    }
}

namespace {

/// A sheet of triangles at the height of the upper side of a body, and one at the lower.
SurfaceMesh twoSheets(double lower, double upper) {
    const SurfaceMesh sheet = flatMesh(7, 5, FaceKind::triangles, ValuesAt::vertices);
    const int n = sheet.nValues();
    Points vertices(2 * n, 3);
    vertices << sheet.vertices(), sheet.vertices();
    vertices.topRows(n).col(2).setConstant(lower);
    vertices.bottomRows(n).col(2).setConstant(upper);
    SurfaceMesh::Faces faces;
    for (const int first : {0, n}) {
        for (int i = 0; i < sheet.nTriangles(); ++i) {
            const std::array<int, 3> corners = sheet.cornerNumbers(i);
            faces.push_back({first + corners[0], first + corners[1], first + corners[2]});
        }
    }
    return SurfaceMesh(vertices, faces, ValuesAt::vertices);
}

/// The plate at z = 0, and another one above it.
SurfaceInterface twoPlates(double height) {
    const NurbsSurface lower = plate(4, 3);
    Points raised = lower.controlPoints();
    raised.col(2).setConstant(height);
    const int n = lower.nControlPoints();
    std::vector<int> numbers(static_cast<std::size_t>(2 * n));
    std::iota(numbers.begin(), numbers.end(), 0);
    return SurfaceInterface({{TrimmedPatch(lower), {numbers.begin(), numbers.begin() + n}, "lower"},
                             {TrimmedPatch(lower.withControlPoints(raised)),
                              {numbers.begin() + n, numbers.end()},
                              "upper"}},
                            2 * n);
}

/// 0 on the lower half of the values, 3 on the upper one.
Eigen::VectorXd onUpperSide(int nValues) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(nValues);
    values.tail(nValues / 2).setConstant(3);
    return values;
}

} // namespace

TEST(PatchMortar, a_thin_bodys_other_side_is_not_mapped_though_it_lies_within_reach) {
    const SurfaceInterface splines = twoPlates(0.01);
    MortarOptions options;
    options.gapLimit.relative = 0.05;
    // The fluid's sides lie on the body's or a little outside.
    for (const double outside : {0.0, 0.002}) {
        const SurfaceMesh mesh = twoSheets(-outside, 0.01 + outside);
        const MortarMapping onto(mesh, splines, options), back(splines, mesh, options);
        const Eigen::VectorXd mapped = onto.apply(onUpperSide(mesh.nValues()));
        EXPECT_LT((mapped - onUpperSide(splines.nValues())).cwiseAbs().maxCoeff(), 1e-12);
        const Eigen::VectorXd mappedBack = back.apply(onUpperSide(splines.nValues()));
        EXPECT_LT((mappedBack - onUpperSide(mesh.nValues())).cwiseAbs().maxCoeff(), 1e-12);
        for (const MortarMapping* mapping : {&onto, &back}) {
            EXPECT_NEAR(mapping->massMatrix().sum(), 2 * 2, 1e-12); // the area of both sides
            EXPECT_NEAR(mapping->report().coverage, 1, 1e-12);
            EXPECT_NEAR(mapping->report().largestGap, outside, 1e-12);
        }
    }
}

TEST(PatchMortar, quadrature_of_a_higher_degree_finds_the_area_of_a_rational_patch) {
    const NurbsSurface cylinder = geometry::cylinderPatch(Point::Zero(), 1, 1, 0, pi / 2);
    Points vertices(2 * 13, 3);
    SurfaceMesh::Faces faces;
    for (int i = 0; i < 13; ++i) {
        const double angle = pi / 2 * i / 12;
        vertices.row(i) << std::cos(angle), std::sin(angle), 0;
        vertices.row(13 + i) << std::cos(angle), std::sin(angle), 1;
        if (i > 0) {
            faces.push_back({i - 1, i, 13 + i, 12 + i});
        }
    }
    const SurfaceMesh mesh(vertices, faces, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(cylinder));
    const auto error = [&](int degree) {
        MortarOptions options;
        options.patchQuadratureDegree = degree;
        options.singular = SingularMass::minimumNorm;
        return std::abs(MortarMapping(mesh, splines, options).massMatrix().sum() - pi / 2);
    };
    // Degrees of the patch 2 and 1, so that the default is the one of 3.
    EXPECT_EQ(error(0), error(3));
    EXPECT_LT(error(8), 1e-2 * error(3));
    EXPECT_GT(error(1), 10 * error(3));
}

TEST(PatchMortar, face_whose_corners_lie_far_beyond_the_patch_covers_it) {
    Points vertices(3, 3);
    vertices << -5, -4, 0, 8, -4, 0, 0, 7, 0;
    const SurfaceMesh mesh(vertices, {{0, 1, 2}}, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(plate(3, 2)));
    expectPatchTest(mesh, splines);
    const MortarMapping mapping(mesh, splines);
    EXPECT_NEAR(mapping.massMatrix().sum(), 2, 1e-13);
    EXPECT_NEAR(mapping.report().coverage, 1, 1e-12);
}

TEST(PatchMortar, control_points_that_are_not_on_the_interface_count_as_no_gap) {
    // The structure has five more than the patch.
    const geometry::TrimmedPatch patch(plate(4, 3));
    std::vector<int> numbers(static_cast<std::size_t>(patch.basis().nControlPoints()));
    std::iota(numbers.begin(), numbers.end(), 5);
    const SurfaceInterface splines({{patch, numbers, "patch"}}, 5 + patch.basis().nControlPoints());
    const SurfaceMesh mesh = flatMesh(6, 4, FaceKind::triangles, ValuesAt::vertices);
    const MortarMapping mapping(mesh, splines);
    EXPECT_EQ(mapping.report().nUncovered, 0);
    const Eigen::VectorXd mapped = mapping.apply(Eigen::VectorXd::Ones(mesh.nValues()));
    EXPECT_EQ(mapped.head(5).norm(), 0);
    EXPECT_LT((mapped.tail(mapped.size() - 5).array() - 1).abs().maxCoeff(), 1e-12);
}

TEST(PatchMortar, the_dual_basis_is_refused) {
    MortarOptions options;
    options.basis = MortarBasis::dual;
    const SurfaceMesh mesh = flatMesh(3, 3, FaceKind::triangles, ValuesAt::vertices);
    expectInputError([&] { MortarMapping(mesh, onePatch(TrimmedPatch(plate(2, 2))), options); },
                     {"dual basis"});
}

TEST(PatchIntersection, a_triangle_whose_corner_newtons_method_does_not_meet_covers_nothing) {
    const SurfaceInterface splines = onePatch(TrimmedPatch(geometry::parabolicCylinder()));
    const auto share = [&](double height) {
        Points vertices(3, 3);
        vertices << 0, height, 0.3, 0.4, 0.3, 0.2, 0.1, 0.3, 0.8;
        const SurfaceMesh mesh(vertices, {{0, 1, 2}}, ValuesAt::faces);
        double covered = -1;
        IntersectionVisitor visitor;
        visitor.point = [](const IntersectionPoint&) {};
        visitor.endTriangle = [&](int, double coveredShare) { covered = coveredShare; };
        intersect(mesh, splines, 1, 2, visitor);
        return covered;
    };
    EXPECT_NEAR(share(0.4), 1, 1e-12);
    EXPECT_EQ(share(0.5), 0); // the centre of curvature of the cylinder's vertex
}

TEST(SurfaceInterface, nearest_element_evaluates_the_splines_exactly) {
    for (const SurfaceInterface& splines :
         {onePatch(TrimmedPatch(bentParameters(6, 4))), twoPatches()}) {
        const Points to = flatMesh(8, 6, FaceKind::triangles, ValuesAt::vertices).coordinates();
        const NearestElementMapping mapping(splines, to);
        EXPECT_LT((mapping.apply(linearField(splines.coordinates())) - linearField(to)).norm(),
                  1e-12);
        expectForceAndMomentConserved(mapping, probeForces(to.rows()), splines.coordinates(), to);
    }
}

TEST(SurfaceInterface, a_point_over_a_hole_gets_the_rim_of_the_hole) {
    const SurfaceInterface splines = onePatch(holedPlate());
    // Along y the rim is an arc of radius 0.23 around (0.9, 0.55).
    const Location rim = splines.locate(Point(0.9, 0.60, 0));
    EXPECT_TRUE(rim.converged);
    EXPECT_NEAR(rim.gap, 0.18, 1e-12);
    EXPECT_NEAR(splines.locate(Point(0.9, 0.9, 0)).gap, 0, 1e-14);
}

TEST(SurfaceInterface, is_closed_along_the_direction_in_which_its_ends_meet) {
    const auto isClosed = [](double gap) {
        const NurbsSurface cylinder = geometry::cylinderPatch(Point::Zero(), 1, 1, 0, 2 * pi);
        Points points = cylinder.controlPoints();
        points(cylinder.u().nBasis() - 1, 1) -= gap; // at one corner
        return onePatch(TrimmedPatch(cylinder.withControlPoints(points))).isClosed(0);
    };
    using Closed = std::array<bool, 2>;
    EXPECT_EQ(isClosed(0), (Closed{true, false}));
    EXPECT_EQ(isClosed(1e-14), (Closed{true, false})); // rounding
    EXPECT_EQ(isClosed(1e-3), (Closed{false, false}));
}

TEST(SurfaceInterface, size_is_the_diagonal_of_its_box) {
    EXPECT_NEAR(twoPatches().size(), std::hypot(2, 1), 1e-15);
}

TEST(SurfaceInterface, the_middle_of_a_round_hole_is_ambiguous) {
    // One curve around it: an ellipse, nearest above and below its centre.
    EXPECT_TRUE(onePatch(holedPlate()).locate(Point(0.9, 0.55, 0)).ambiguous);
    EXPECT_FALSE(onePatch(holedPlate()).locate(Point(0.9, 0.56, 0)).ambiguous);
}

TEST(SurfaceInterface, points_as_near_to_two_places_are_ambiguous) {
    // In the middle of a square hole, and between two plates.
    const geometry::NurbsSurface square = geometry::rectangle(Point::Zero(), 1, 1);
    const TrimmedPatch holed(
        square, {geometry::TrimmingLoop::around({{0, 0}, {1, 1}}),
                 geometry::TrimmingLoop(geometry::LoopKind::inner,
                                        {geometry::line(Point(0.4, 0.4, 0), Point(0.4, 0.6, 0)),
                                         geometry::line(Point(0.4, 0.6, 0), Point(0.6, 0.6, 0)),
                                         geometry::line(Point(0.6, 0.6, 0), Point(0.6, 0.4, 0)),
                                         geometry::line(Point(0.6, 0.4, 0), Point(0.4, 0.4, 0))})});
    EXPECT_TRUE(onePatch(holed).locate(Point(0.5, 0.5, 0)).ambiguous);
    EXPECT_FALSE(onePatch(holed).locate(Point(0.5, 0.45, 0)).ambiguous);
    const TrimmedPatch below(geometry::rectangle(Point::Zero(), 1, 1));
    const TrimmedPatch above(geometry::rectangle(Point(0, 0, 1), 1, 1));
    const SurfaceInterface plates({{below, {0, 1, 2, 3}, "below"}, {above, {4, 5, 6, 7}, "above"}},
                                  8);
    EXPECT_TRUE(plates.locate(Point(0.3, 0.6, 0.5)).ambiguous);
    EXPECT_FALSE(plates.locate(Point(0.3, 0.6, 0.4)).ambiguous);
}

TEST(SurfaceInterface, refuses_patches_that_do_not_fit_the_structure) {
    const TrimmedPatch patch(geometry::rectangle(Point::Zero(), 1, 1));
    expectInputError([&] { SurfaceInterface({}, 4); }, {"no patch"});
    expectInputError(
        [&] {
            SurfaceInterface({{patch, {0, 1, 2}, "roof"}}, 4);
        },
        {"roof", "3", "4"});
    expectInputError(
        [&] {
            SurfaceInterface({{patch, {0, 1, 2, 7}, "roof"}}, 4);
        },
        {"roof", "control point 7", "has 4"});
}

} // namespace tokay::mapper
