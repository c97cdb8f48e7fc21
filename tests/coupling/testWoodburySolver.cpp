// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/WoodburySolver.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int nUnknowns = 30;
constexpr int nPoints = 20;
constexpr int rank = 8;

/// A tangent that may be changed, and counts its back-substitutions.
class Tangent : public LinearisedStructure {
  public:
    Tangent() : K(MatrixXd::Identity(nUnknowns, nUnknowns)), P(MatrixXd::Zero(nPoints, nUnknowns)) {
        std::srand(7);
        K += 0.1 * MatrixXd::Random(nUnknowns, nUnknowns);
        P.leftCols(nPoints).setIdentity();
    }

    MatrixXd responses(const MatrixXd& b) override {
        nSolved += static_cast<int>(b.cols());
        return K.partialPivLu().solve(b);
    }
    MatrixXd variations(const MatrixXd& D) override { return P * D; }

    VectorXd acceptedUnknowns() const override { return VectorXd::Zero(nUnknowns); }
    VectorXd residual(const VectorXd& d) override { return K * d; }
    void linearise(const VectorXd&) override {}
    VectorXd displacements(const VectorXd& d) override { return P * d; }
    VectorXd loads(const VectorXd& forces, const VectorXd&) override { return forces; }
    VectorXd solveFor(const VectorXd& loads, const VectorXd&) override { return responses(loads); }

    MatrixXd K;
    MatrixXd P;
    int nSolved = 0;
};

class WoodburySolving : public testing::Test {
  protected:
    WoodburySolving() { appendColumns(rank); }

    void appendColumns(int n) {
        J.append(0.3 * MatrixXd::Random(nUnknowns, n), MatrixXd::Random(nPoints, n));
    }

    /// |b - (K - A Bᵀ P) d| / |b| of a new right-hand side, and the back-substitutions.
    double error() {
        const VectorXd b = VectorXd::Random(nUnknowns);
        structure.nSolved = 0;
        const VectorXd d = solver.solve(J, b);
        return (b - structure.K * d + J.apply(structure.P * d, nUnknowns)).norm() / b.norm();
    }

    Tangent structure;
    LowRankMatrix J;
    WoodburySolver solver{structure};
};

// Numbers of 30 unknowns, conditions below 1e3.
constexpr double rounding = 1e-11;

TEST_F(WoodburySolving, solves_the_structure_in_the_fluid) {
    EXPECT_LT(error(), rounding);
    EXPECT_EQ(structure.nSolved, rank + 2);
}

TEST_F(WoodburySolving, without_a_response_solves_the_structure_alone) {
    J = {};
    EXPECT_LT(error(), rounding);
    EXPECT_EQ(structure.nSolved, 1);
}

TEST_F(WoodburySolving, keeps_what_it_knows_of_columns) {
    error();
    EXPECT_LT(error(), rounding);
    EXPECT_EQ(structure.nSolved, 2);
    appendColumns(1);
    EXPECT_LT(error(), rounding);
    EXPECT_EQ(structure.nSolved, 3);
    J.compress(rank / 2, 0);
    EXPECT_LT(error(), rounding);
    EXPECT_EQ(structure.nSolved, rank / 2 + 2);
}

TEST_F(WoodburySolving, refines_for_a_tangent_that_has_changed_a_little) {
    error();
    structure.K.diagonal() *= 1.001;
    EXPECT_LT(error(), 1e-5); // c to 1e-6
    EXPECT_LT(structure.nSolved, rank);
}

TEST_F(WoodburySolving, begins_anew_for_a_tangent_that_has_changed_much) {
    error();
    structure.K.diagonal() *= 3;
    EXPECT_LT(error(), rounding);
    EXPECT_LT(error(), rounding);
    EXPECT_EQ(structure.nSolved, 2);
}

TEST_F(WoodburySolving, after_forgetting_depends_on_its_arguments_alone) {
    const VectorXd b = VectorXd::Random(nUnknowns);
    const MatrixXd K = structure.K;
    const VectorXd first = solver.solve(J, b);
    structure.K.diagonal() *= 1.001;
    error();
    structure.K = K;
    solver.forget();
    EXPECT_EQ(solver.solve(J, b), first);
}

} // namespace
} // namespace tokay::coupling
