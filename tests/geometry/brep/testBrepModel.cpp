// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/BrepModel.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleModels.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

int countShared(const BrepModel& model) {
    int n = 0;
    for (const BrepEdge& edge : model.edges()) {
        n += edge.trims.size() == 2;
    }
    return n;
}

} // namespace

TEST(BrepModel, finds_the_edges_that_faces_share) {
    const BrepModel model = twoSquares();
    ASSERT_EQ(countShared(model), 1);
    EXPECT_EQ(model.edges().size(), 3u + 1 + 1 + 3); // free, hole, shared, free
    const BrepEdge& shared = model.edges()[model.edgeNumber("left.1-right.3")];
    EXPECT_FALSE(shared.trims[1].isForward) << "both loops run counter-clockwise";
    for (const double t : {0.0, 0.3, 1.0}) {
        EXPECT_LT((model.curveInSpace(shared.trims[0]).derivatives(t, 0) -
                   model.curveInSpace(shared.trims[1]).derivatives(1 - t, 0))
                      .norm(),
                  1e-15);
    }
    EXPECT_EQ(countShared(halfCylinders()), 2);
}

TEST(BrepModel, seam_and_poles_of_a_sphere_are_one_edge) {
    const std::vector<BrepFace> faces = {{TrimmedPatch(sphere(Point::Zero(), 1), "ball")}};
    const std::vector<BrepEdge> edges = coincidentEdges(faces, 1e-9);
    ASSERT_EQ(edges.size(), 1u);
    EXPECT_EQ(edges[0].trims.size(), 2u);
}

TEST(BrepModel, names_are_found_and_listed) {
    const BrepModel model = twoSquares();
    EXPECT_EQ(model.faceNumber("right"), 1);
    expectInputError([&] { model.faceNumber("wrong"); }, {"face \"wrong\"", "left, right"});
    expectInputError([&] { model.edgeNumber("left.7"); }, {"left.7", "left.1-right.3"});
}

TEST(BrepModel, refuses_contradictions) {
    const BrepFace face{TrimmedPatch(rectangle(Point::Zero(), 1, 1), "a")};
    expectInputError([] { BrepModel({}); }, {"no face"});
    expectInputError([&] { BrepModel({face, face}); }, {"two faces", "\"a\""});
    expectInputError([&] { BrepModel({face}, {{"e", {{1, 0}}}}); }, {"edge \"e\"", "face 1"});
    expectInputError([&] { BrepModel({face}, {{"e", {{0, 4}}}}); }, {"curve 4", "4"});
    expectInputError(
        [&] {
            BrepModel({face}, {{"e", {{0, 0}}}, {"e", {{0, 1}}}});
        },
        {"two edges", "\"e\""});
}

TEST(BrepModel, refinement_changes_the_basis_of_every_face_only) {
    const BrepModel fine = twoSquares().refined(2, 2, 4, 4);
    EXPECT_EQ(fine.patch(0).nElements(), 16);
    EXPECT_EQ(fine.patch(1).basis().u().degree(), 2);
    EXPECT_LT(largestGap(fine, fine.edges()[fine.edgeNumber("left.1-right.3")]), 1e-15);
}

} // namespace tokay::geometry
