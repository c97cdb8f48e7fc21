// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/conservation.hpp"
#include "mapper/expectPatchTest.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/sampleMeshes.hpp"
#include "mapper/samplePatches.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

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

TEST(PatchMortar, the_dual_basis_is_refused) {
    MortarOptions options;
    options.basis = MortarBasis::dual;
    const SurfaceMesh mesh = flatMesh(3, 3, FaceKind::triangles, ValuesAt::vertices);
    expectInputError([&] { MortarMapping(mesh, onePatch(TrimmedPatch(plate(2, 2))), options); },
                     {"dual basis"});
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
