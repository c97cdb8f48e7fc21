// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/refinement.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

namespace {

// Coordinates are of size 6; refinement is a chain of averages: a few roundings.
constexpr double rounding = 2e-14;

void expectSameCurve(const NurbsCurve& a, const NurbsCurve& b) {
    for (const double xi : sampleParameters(101)) {
        EXPECT_LT((a.point(xi) - b.point(xi)).norm(), rounding) << "at " << xi;
    }
}

void expectSameSurface(const NurbsSurface& a, const NurbsSurface& b) {
    for (const double xi : sampleParameters(21)) {
        for (const double eta : sampleParameters(21)) {
            EXPECT_LT((a.point(xi, eta) - b.point(xi, eta)).norm(), rounding)
                << "at " << xi << ", " << eta;
        }
    }
}

} // namespace

TEST(Refinement, knot_insertion_leaves_a_rational_curve_unchanged) {
    const NurbsCurve curve = sampleCurve();
    const NurbsCurve fine = insertKnots(curve, {0.1, 0.3, 0.3, 0.5, 0.7, 0.99});
    EXPECT_EQ(fine.nControlPoints(), curve.nControlPoints() + 6);
    expectSameCurve(curve, fine);
}

TEST(Refinement, knots_inserted_and_removed_leave_the_same_control_points) {
    const NurbsCurve curve = sampleCurve();
    const std::vector<double> knots = {0.1, 0.3, 0.3, 0.5, 0.7, 0.99};
    const NurbsCurve back = removeKnots(insertKnots(curve, knots), knots);
    EXPECT_EQ(back.knotVector().knots(), curve.knotVector().knots());
    // As far as the blossom extrapolates beyond a short span, roundings grow.
    EXPECT_LT((back.controlPoints() - curve.controlPoints()).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT((back.weights() - curve.weights()).cwiseAbs().maxCoeff(), 1e-11);
    const NurbsSurface surface = sampleSurface();
    const NurbsSurface same =
        removeKnots(insertKnots(surface, {0.4}, {0.2, 0.6}), {0.4}, {0.2, 0.6});
    EXPECT_LT((same.controlPoints() - surface.controlPoints()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Refinement, a_knot_that_the_curve_needs_is_not_removed) {
    expectInputError([] { removeKnots(curveWithCorner(), {0.5}); }, {"not smooth enough"});
    expectInputError([] { removeKnots(sampleCurve(), {0.123}); },
                     {"the knot 0.123 cannot be removed"});
    expectInputError([] { removeKnots(sampleCurve(), {0}); }, {"the knot 0 cannot be removed"});
}

TEST(Refinement, degree_elevation_leaves_a_rational_curve_unchanged) {
    const NurbsCurve curve = sampleCurve(), fine = elevateDegree(curve, 3);
    EXPECT_EQ(fine.degree(), 6);
    // Continuity stays: multiplicities grow with the degree.
    EXPECT_EQ(fine.knotVector().multiplicity(0.3), 4);
    EXPECT_EQ(fine.knotVector().multiplicity(0.7), 5);
    expectSameCurve(curve, fine);
}

TEST(Refinement, elevation_keeps_a_corner_where_it_is) {
    const NurbsCurve curve = curveWithCorner(), fine = elevateDegree(curve, 2);
    EXPECT_EQ(fine.point(0.5), Point(2, 0, 0));
    expectSameCurve(curve, fine);
}

TEST(Refinement, surface_refinement_leaves_a_rational_surface_unchanged) {
    const NurbsSurface surface = sampleSurface(), fine = refine(surface, 3, 5, 3, 2);
    EXPECT_EQ(fine.u().degree(), 3);
    EXPECT_EQ(fine.v().degree(), 5);
    EXPECT_EQ(fine.u().nSpans(), 6);
    EXPECT_EQ(fine.v().nSpans(), 6);
    expectSameSurface(surface, fine);
    expectSameSurface(surface, insertKnots(elevateDegree(surface, 0, 1), {0.4, 0.6}, {}));
}

TEST(Refinement, k_refinement_gives_a_primitive_smooth_spans) {
    const NurbsSurface plate = refine(rectangle(Point::Zero(), 2, 1), 2, 3, 4, 5);
    EXPECT_EQ(plate.u().nBasis(), 6); // 4 spans, degree 2, C1
    EXPECT_EQ(plate.v().nBasis(), 8); // 5 spans, degree 3, C2
    EXPECT_LT((plate.point(0.3, 0.8) - Point(0.6, 0.8, 0)).norm(), 1e-15);
}

TEST(Refinement, bezier_pieces_are_the_patch_piece_by_piece) {
    const NurbsSurface surface = sampleSurface();
    const std::vector<NurbsSurface> pieces = bezierPieces(surface);
    ASSERT_EQ(pieces.size(), 6u);
    for (const NurbsSurface& piece : pieces) {
        EXPECT_EQ(piece.nControlPoints(), 12);
        for (const double s : sampleParameters(4)) {
            for (const double t : sampleParameters(4)) {
                const double xi = piece.u().first() + s * (piece.u().last() - piece.u().first());
                const double eta = piece.v().first() + t * (piece.v().last() - piece.v().first());
                EXPECT_LT((piece.point(xi, eta) - surface.point(xi, eta)).norm(), rounding);
            }
        }
    }
}

TEST(Refinement, refuses_knots_outside_and_lower_degrees) {
    const NurbsCurve curve = sampleCurve();
    expectInputError([&] { insertKnots(curve, {1.5}); }, {"1.5", "(0, 1)"});
    expectInputError([&] { insertKnots(curve, {0.6, 0.5}); }, {"ascending"});
    expectInputError([&] { insertKnots(curve, {0.7, 0.7}); }, {"0.7", "4 times"});
    expectInputError([&] { elevateDegree(curve, -1); }, {"-1"});
    expectInputError([&] { refine(curve, 2, 1); }, {"degree 2", "3"});
    expectInputError([&] { refine(curve, 3, 0); }, {"0 parts"});
}

} // namespace tokay::geometry
