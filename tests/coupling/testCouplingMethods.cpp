// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/BlockQuasiNewton.hpp"
#include "coupling/couplingMethods.hpp"

#include <gtest/gtest.h>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double tolerance = 1e-6;

/// Springs that the interface sees as they are: x̃ = rest + compliance * force.
class LinearSprings : public CoupledStructure, public LinearisedStructure {
  public:
    LinearSprings(double rest, double compliance) : rest_(rest), compliance_(compliance) {}

    VectorXd acceptedDisplacements() const override { return VectorXd::Constant(1, rest_); }
    VectorXd solve(const VectorXd& forces) override {
        return acceptedDisplacements() + compliance_ * forces;
    }
    LinearisedStructure* linearised() override { return this; }

    VectorXd acceptedUnknowns() const override { return acceptedDisplacements(); }
    VectorXd residual(const VectorXd& d) override { return (d - acceptedUnknowns()) / compliance_; }
    void linearise(const VectorXd&) override {}
    MatrixXd responses(const MatrixXd& b) override { return compliance_ * b; }
    VectorXd displacements(const VectorXd& d) override { return d; }
    MatrixXd variations(const MatrixXd& D) override { return D; }
    VectorXd loads(const VectorXd& forces, const VectorXd&) override { return forces; }
    VectorXd solveFor(const VectorXd& loads, const VectorXd&) override { return solve(loads); }

  private:
    double rest_, compliance_;
};

VectorXd force(double size) {
    return VectorXd::Constant(1, size);
}

/// A method that predicts no change, and its structure.
struct Coupled {
    Coupled(const char* name, double rest, double compliance) : springs(rest, compliance) {
        CouplingOptions options;
        options.acceleration.type = name;
        options.predictor = Extrapolation::constant;
        method = makeCouplingMethod(options, tolerance, springs);
    }

    LinearSprings springs;
    std::unique_ptr<CouplingMethod> method;
};

class IteratingMethod : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Types, IteratingMethod,
                         testing::Values("aitken", "iqnIls", "mvqn", "block"));

TEST_P(IteratingMethod, does_not_compare_forces_with_those_of_the_step_before) {
    Coupled coupled(GetParam(), 0, 1);
    CouplingMethod& method = *coupled.method;
    method.predict(1);
    for (int i = 0; i < 20 && !method.statistics().converged; ++i) {
        method.iterate(force(3), std::nullopt);
    }
    ASSERT_TRUE(method.statistics().converged);
    method.accept(force(3));
    method.predict(1); // is right, but whether the force still changes is not known
    EXPECT_FALSE(method.iterate(force(3), std::nullopt).converged);
    EXPECT_TRUE(method.iterate(force(3), std::nullopt).converged);
}

TEST_P(IteratingMethod, compares_a_force_that_fades_with_those_of_accepted_steps) {
    const auto convergesAfter = [](double before) {
        Coupled coupled(GetParam(), 1, 1e-9); // too stiff to move by the tolerance
        CouplingMethod& method = *coupled.method;
        for (int step = 0; step < 3; ++step) {
            method.predict(1);
            method.accept(force(before));
        }
        method.predict(1);
        method.iterate(force(9e-5), std::nullopt);
        return method.iterate(force(0), std::nullopt).converged;
    };
    EXPECT_TRUE(convergesAfter(10)); // of which ten tolerances are 1e-4
    EXPECT_FALSE(convergesAfter(0));
}

TEST_P(IteratingMethod, ends_a_step_with_the_structural_solution_and_predicts_from_it) {
    Coupled coupled(GetParam(), 0, 1);
    coupled.method->predict(1);
    coupled.method->iterate(force(1), 0);
    EXPECT_EQ(coupled.method->accept(force(2)).x[0], 2);
    EXPECT_EQ(coupled.method->predict(1)[0], 2);
}

TEST_P(IteratingMethod, goes_on_where_the_fluid_has_stayed_after_a_residual_at_the_limit) {
    Coupled coupled(GetParam(), 1, 1);
    CouplingMethod& method = *coupled.method;
    method.predict(1);
    method.iterate(force(1), 0);                          // proposes another x than 1
    EXPECT_FALSE(method.accept(force(1), 0.5).converged); // (2 - 1) / 2
    method.iterate(force(1), 0);
    EXPECT_EQ(method.x()[0], 1);
    EXPECT_TRUE(method.accept(force(1), 0.5001).converged);
}

TEST(QuasiNewtonMethods, learn_nothing_from_a_move_below_the_residual_of_the_fluid) {
    const auto nColumns = [](const char* type, double fluidResidual) {
        Coupled coupled(type, 1, 1);
        coupled.method->predict(1);
        coupled.method->iterate(force(1), fluidResidual);
        coupled.method->iterate(force(1.05), fluidResidual);
        return coupled.method->statistics().nColumns;
    };
    for (const char* type : {"iqnIls", "mvqn"}) {
        EXPECT_EQ(nColumns(type, 0), 1);
        EXPECT_EQ(nColumns(type, 0.5), 0); // of 2, against a move of a tenth
    }
}

/// Block method of one unknown, x̃ = force, in a fluid whose force is 1 - slope * x.
class BlockOfOneUnknown {
  public:
    explicit BlockOfOneUnknown(double slope, const BlockQuasiNewton::Options& own = {})
        : slope_(slope) {
        CouplingOptions options;
        options.predictor = Extrapolation::constant;
        options.acceleration.of<BlockQuasiNewton::Options>() = own;
        method_ = makeCouplingMethod(options, tolerance, springs_);
    }

    CouplingMethod& operator*() { return *method_; }
    CouplingMethod* operator->() { return method_.get(); }
    double force(double x) const { return 1 - slope_ * x; }
    int nColumns() const { return method_->statistics().nColumns; }

    /// @return  the next x
    double iterate(double x, double fluidResidual = 0) {
        return method_->iterate(coupling::force(force(x)), fluidResidual).x[0];
    }

  private:
    double slope_;
    LinearSprings springs_{0, 1};
    std::unique_ptr<CouplingMethod> method_;
};

TEST(BlockMethod, learns_half_of_a_difference_that_is_as_large_as_the_fluids_residual) {
    BlockQuasiNewton::Options options;
    options.signalToNoise = 1;
    BlockOfOneUnknown block(2, options);
    block->predict(1);
    const double x = block.iterate(0);
    // From 0 to x is a move of x: weight 1 / (1 + 1), so that the force seems to be F - (y - x).
    EXPECT_NEAR(block.iterate(x, 1), (block.force(x) + x) / 2, 1e-14);
    EXPECT_EQ(block.nColumns(), 1);
}

TEST(BlockMethod, ends_a_step_where_structure_and_fluid_agree_once_its_response_is_known) {
    BlockOfOneUnknown block(2);
    block->predict(1);
    const double x = block.iterate(0);
    block.iterate(x);
    // The fluid has stayed at x, far from 1 - 2 y = y.
    EXPECT_NEAR(block->accept(force(block.force(x))).x[0], 1.0 / 3, 1e-14);
}

TEST(BlockMethod, learns_nothing_from_drift_at_the_same_displacement) {
    Coupled coupled("block", 1, 1);
    coupled.method->predict(1);
    coupled.method->iterate(force(0), 1); // in balance, so that it stays where it is
    coupled.method->iterate(force(0.3), 1);
    EXPECT_EQ(coupled.method->statistics().nColumns, 0);
}

TEST(BlockMethod, learns_nothing_from_a_difference_that_the_fluids_memory_explains) {
    BlockQuasiNewton::Options options;
    options.fluidMemory = 0.1;
    options.memoryContrast = 5;
    BlockOfOneUnknown block(2, options);
    block->predict(1);
    block->iterate(force(1), 0);
    block->iterate(force(3), 0);
    EXPECT_EQ(block.nColumns(), 1);
    block->iterate(force(3.3), 0); // within 5 q / (1 - q), q = 0.03 / 0.93
    EXPECT_EQ(block.nColumns(), 1);
    block->iterate(force(4), 0);
    EXPECT_EQ(block.nColumns(), 2);
}

TEST(BlockMethod, rejected_forces_do_not_count_as_what_the_fluid_remembers) {
    BlockQuasiNewton::Options options;
    options.fluidMemory = 0.1;
    BlockOfOneUnknown block(2, options);
    block->predict(1);
    block->iterate(force(1), 0);
    block->iterate(force(1e6), 0);
    block->reject();
    block->predict(1);
    block->iterate(force(1), 0);
    block->iterate(force(3), 0);
    EXPECT_EQ(block.nColumns(), 1);
}

TEST(BlockMethod, rank_of_what_it_has_learned_stays_bounded_over_time_steps) {
    BlockOfOneUnknown block(2);
    for (int step = 1; step <= 8; ++step) { // the load on the fluid grows
        const auto forceAt = [&](double x) { return force(step - 2 * x); };
        const double x = block->predict(1)[0];
        const double next = block->iterate(forceAt(x), 0).x[0];
        block->iterate(forceAt(next), 0);
        EXPECT_LE(block.nColumns(), 3); // twice the number of unknowns, and one of the step
        block->accept(forceAt(next));
    }
}

} // namespace
} // namespace tokay::coupling
