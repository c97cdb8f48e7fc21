// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleShell.hpp"
#include "igaStructure/kinematics/shell/edges/EdgeTraction.hpp"
#include "igaStructure/kinematics/shell/edges/TractionBounds.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::vector<EdgePiece> piecesOf(const std::vector<EdgePoint>& points) {
    std::vector<EdgePiece> pieces;
    for (const EdgePoint& point : points) {
        pieces.push_back({&point.side, point.weight});
    }
    return pieces;
}

// Largest square of the rows over the energy, from the eigenvalues of the stiffness,
// whose square root the bounds use: half as many digits are left here.
double largestShare(const MatrixXd& rows, const MatrixXd& stiffness) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(stiffness);
    const double least = 1e-12 * parts.eigenvalues().maxCoeff();
    MatrixXd motions = parts.eigenvectors();
    for (Eigen::Index k = 0; k < motions.cols(); ++k) {
        const double value = parts.eigenvalues()[k];
        motions.col(k) *= value > least ? 1 / std::sqrt(value) : 0;
    }
    return std::pow((rows * motions).jacobiSvd().singularValues()[0], 2);
}

} // namespace

TEST(TractionBounds, of_the_moment_are_the_inverse_inequality_of_its_degree) {
    // Without Poisson's ratio the moment about a side of a rectangle is D w,xx, along x a
    // polynomial of degree p - 2: its square there is at most (p - 1)^2 / h times the
    // integral over h (the sum of 2 k + 1), and y does not matter.
    constexpr double thickness = 0.1, width = 0.4;
    const double D = 1e6 * std::pow(thickness, 3) / 12;
    for (const int degree : {2, 3, 4}) {
        ShellDescription plate = onePatch(geometry::plate({0, 0, 0}, {width, 0, 0}, {0, 1, 0}),
                                          degree, 1, 1, thickness, {1e6, 0, 1});
        plate.strains = Strains::linear;
        const Shell shell(plate);
        const ShellPatch& patch = *shell.patches()[0];
        const std::vector<EdgePoint> points = edgePoints(patch, plate.model.curve(0, left));
        const TractionBounds bounds =
            tractionBounds(patch, 0, piecesOf(points), {false, true, true});
        const double expected = D * (degree - 1) * (degree - 1) / width;
        EXPECT_NEAR(bounds.moment, expected, 1e-9 * expected) << degree;
        EXPECT_EQ(bounds.shear, 0);
        EXPECT_EQ(bounds.membrane, 0);
    }
}

TEST(TractionBounds, the_worst_motion_of_a_cut_element_just_meets_them) {
    // Less than half of a square is left by a slanted cut, along which the tractions are.
    const geometry::TrimmedPatch whole(
        geometry::rectangle({0, 0, 0}, 1, 1),
        {geometry::TrimmingLoop(
            geometry::LoopKind::outer,
            {geometry::line({0, 0, 0}, {0.6, 0, 0}), geometry::line({0.6, 0, 0}, {0.2, 1, 0}),
             geometry::line({0.2, 1, 0}, {0, 1, 0}), geometry::line({0, 1, 0}, {0, 0, 0})})},
        "cut");
    for (const int degree : {2, 3, 4}) {
        ShellDescription plate{
            geometry::BrepModel({{whole.refined(degree, degree, 1, 1)}}), {0.1}, {1e6, 0.3, 1}};
        plate.strains = Strains::linear;
        const Shell shell(plate);
        const ShellPatch& patch = *shell.patches()[0];
        const std::vector<EdgePoint> points = edgePoints(patch, plate.model.curve(0, 1));
        const TractionBounds bounds =
            tractionBounds(patch, 0, piecesOf(points), {true, true, true});

        // Of the z of the nodes and of their x and y; rows are what is bounded, over its
        // bound's root.
        const Eigen::Index n = shell.nUnknowns() / 3;
        MatrixXd membrane = MatrixXd::Zero(2 * points.size(), 3 * n);
        MatrixXd bending = MatrixXd::Zero(3 * points.size(), 3 * n);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const EdgeTraction traction(points[k].side, 0, true);
            for (std::size_t f = 0; f < traction.nodes.size(); ++f) {
                const auto own = 3 * static_cast<Eigen::Index>(f);
                const Eigen::Index all = 3 * traction.nodes[f];
                membrane.block<2, 3>(2 * k, all) = std::sqrt(points[k].weight / bounds.membrane) *
                                                   traction.force.block<2, 3>(0, own);
                const auto add = [&](int row, const auto& what, double bound) {
                    bending.block<1, 3>(3 * k + row, all) =
                        std::sqrt(points[k].weight / bound) * what;
                };
                add(0, traction.force.block<1, 3>(2, own), bounds.shear);
                add(1, traction.twist.block<1, 3>(2, own), bounds.twist);
                add(2, traction.moment.segment<3>(own), bounds.moment);
            }
        }
        SparseMatrix tangent;
        shell.internalForce(VectorXd::Zero(3 * n), tangent);
        const MatrixXd stiffness(tangent);
        std::vector<Eigen::Index> inPlane, across;
        for (Eigen::Index k = 0; k < 3 * n; ++k) {
            (k % 3 == 2 ? across : inPlane).push_back(k);
        }
        EXPECT_NEAR(largestShare(membrane(Eigen::all, inPlane), stiffness(inPlane, inPlane)), 1,
                    1e-6)
            << degree;
        EXPECT_NEAR(largestShare(bending(Eigen::all, across), stiffness(across, across)), 1, 1e-6)
            << degree;
    }
}
