// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/ScriptedFluid.hpp"
#include "igaStructure/coupledRun/InterfaceFaces.hpp"
#include "igaStructure/coupledRun/wetCoverage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace tokay;
using namespace tokay::structure;

namespace {

using testing::HasSubstr;

/// Edges of the example's flap, 0.1 m by 1 m.
WetSurface flap(const std::vector<std::string>& names = {"left", "top", "right"}) {
    const geometry::NurbsSurface surface =
        geometry::refine(geometry::rectangle({-0.05, 0, 0}, 0.1, 1), 2, 3, 2, 8);
    std::vector<mapper::SplinePiece> pieces;
    for (const std::string& name : names) {
        geometry::BoundaryCurve edge = surface.boundaryCurve(geometry::edgeFromName(name));
        pieces.push_back({std::move(edge.curve), std::move(edge.controlPoints), name});
    }
    return mapper::SplineInterface(std::move(pieces), surface.nControlPoints());
}

/// The fluid's faces around the example's flap.
mapper::FaceMesh flapFaces(int facesAlongHeight) {
    return InterfaceFaces(flapInterface(facesAlongHeight)).mesh();
}

/// The fluid's faces without those from begin to end.
mapper::FaceMesh without(mapper::FaceMesh fluid, int begin, int end) {
    fluid.faces.erase(fluid.faces.begin() + begin, fluid.faces.begin() + end);
    return fluid;
}

std::vector<double> fractions(const std::vector<WetPart>& parts) {
    std::vector<double> result;
    for (const WetPart& part : parts) {
        result.push_back(part.reached / part.size);
    }
    return result;
}

} // namespace

TEST(WetCoverage, all_parts_are_reached_by_faces_around_them_whatever_their_size) {
    for (const int nFaces : {1, 3, 40}) {
        const auto parts = wetCoverage(flap(), flapFaces(nFaces));
        EXPECT_EQ(fractions(parts), std::vector<double>({1, 1, 1})) << nFaces;
        EXPECT_NO_THROW(requireReached(parts));
        EXPECT_NEAR(parts[1].size, 0.1, 1e-12);
    }
}

TEST(WetCoverage, an_edge_without_faces_is_named_though_its_ends_belong_to_faces) {
    const auto parts = wetCoverage(flap(), without(flapFaces(6), 6, 7));
    EXPECT_EQ(fractions(parts), std::vector<double>({1, 0, 1}));
    try {
        requireReached(parts);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("top: no face of the fluid lies before 100 % of it"));
        EXPECT_THAT(error.what(), HasSubstr("coupling.unreached: accept"));
    }
}

TEST(WetCoverage, the_part_of_an_edge_that_is_reached_is_its_fraction) {
    // The upper half of the left edge is missing
    const auto parts = wetCoverage(flap(), without(flapFaces(8), 4, 8));
    EXPECT_EQ(fractions(parts), std::vector<double>({0.5, 1, 1}));
}

TEST(WetCoverage, faces_of_the_other_side_of_a_thin_body_do_not_reach_it) {
    // 0.1 m away from the left edge, faces of 1 m
    const auto parts = wetCoverage(flap(), without(flapFaces(1), 0, 1));
    EXPECT_EQ(fractions(parts), std::vector<double>({0, 1, 1}));
}

TEST(WetCoverage, a_face_on_an_edge_that_is_not_wet_is_refused_though_its_corners_lie_on_others) {
    EXPECT_NO_THROW(requireFacesOnBody(flap(), flapFaces(1)));
    try {
        requireFacesOnBody(flap({"left", "right"}), flapFaces(6));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("1 of 13 faces of the fluid lie on a part of the "
                                            "structure that is not wet: the face at (0, 1, 0) is "
                                            "0.05 m from the wet parts, its corners at most 0 m"));
    }
}

namespace {

/// A cylinder of radius 1 and height 2.
WetSurface cylinder() {
    const geometry::NurbsSurface surface =
        geometry::refine(geometry::cylinderPatch({0, 0, 0}, 1, 2, 0, 2 * M_PI), 2, 2, 8, 2);
    std::vector<int> indices(surface.nControlPoints());
    std::iota(indices.begin(), indices.end(), 0);
    return mapper::SurfaceInterface({{geometry::TrimmedPatch(surface), indices, "wall"}},
                                    surface.nControlPoints());
}

/// Faces of the fluid around it or, with a smaller radius, inside, n around.
mapper::FaceMesh chords(int n, double radius) {
    mapper::FaceMesh fluid{geometry::Points(2 * n, 3), {}};
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * M_PI * i / n;
        const int next = (i + 1) % n;
        fluid.vertices.row(2 * i) << radius * std::cos(angle), radius * std::sin(angle), 0;
        fluid.vertices.row(2 * i + 1) << radius * std::cos(angle), radius * std::sin(angle), 2;
        fluid.faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    return fluid;
}

} // namespace

TEST(WetCoverage, chords_of_a_cylinder_reach_it_and_half_of_them_reach_half) {
    constexpr int n = 12;
    const WetSurface wet = cylinder();
    const mapper::FaceMesh fluid = chords(n, 1);
    EXPECT_NO_THROW(requireFacesOnBody(wet, fluid));
    EXPECT_NEAR(fractions(wetCoverage(wet, fluid))[0], 1, 1e-12);
    EXPECT_NEAR(fractions(wetCoverage(wet, without(fluid, 0, n / 2)))[0], 0.5, 1e-12);
}

// Planes through the edges of the faces, across them, leave wedges between them
TEST(WetCoverage, faces_inside_a_thick_tube_reach_all_of_its_middle_surface) {
    for (const int n : {12, 37, 40}) {
        EXPECT_NEAR(fractions(wetCoverage(cylinder(), chords(n, 0.8)))[0], 1, 1e-12) << n;
    }
}
