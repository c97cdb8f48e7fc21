// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElasticTube.hpp"
#include "coupling/couplingMethods.hpp"
#include "coupling/step/CoupledStructure.hpp"

#include <gtest/gtest.h>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

class Acceptance : public testing::TestWithParam<const char*> {};

/// Iterates with the forces at x until the step has converged.
VectorXd iterated(CouplingMethod& method, ElasticTube& tube, VectorXd x) {
    for (int i = 0; i < 100; ++i) {
        const CouplingIteration iteration = method.iterate(tube.fluid(x), 0);
        if (iteration.converged) {
            return x;
        }
        x = iteration.x;
    }
    ADD_FAILURE() << "not converged";
    return x;
}

TEST_P(Acceptance,
       final_forces_above_the_limit_do_not_end_the_step_which_then_converges_to_the_same_solution) {
    constexpr double tolerance = 1e-7;
    ElasticTube tube(10, 10, 0.01);
    CouplingOptions options;
    options.acceleration.type = GetParam();
    const auto method = makeCouplingMethod(options, tolerance, tube);
    for (int step = 0; step < 10; ++step) {
        tube.beginTimeStep();
        ElasticTube reference = tube;
        const VectorXd exact = reference.monolithic(VectorXd::Zero(10));
        VectorXd x = iterated(*method, tube, method->predict(tube.deltaT()));
        // The fluid has stayed at x, but its final forces have moved on.
        const VectorXd finalForces = 1.01 * tube.fluid(x);
        const CouplingIteration refused = method->accept(finalForces, tolerance);
        EXPECT_FALSE(refused.converged);
        EXPECT_GT(refused.residual, 100 * tolerance);
        EXPECT_EQ((method->x() - x).norm(), 0);
        x = iterated(*method, tube, method->iterate(finalForces, 0).x);
        const CouplingIteration accepted = method->accept(tube.fluid(x), tolerance);
        EXPECT_TRUE(accepted.converged);
        EXPECT_LT(accepted.residual, tolerance);
        // The error is the residual through (1 - S'F')^-1, here of norm one.
        EXPECT_LT((x - exact).norm(), 2 * tolerance * exact.norm());
        tube.acceptTimeStep(x);
    }
}

/// A structure so heavy that no force moves it by the tolerance within a step.
class Immovable : public CoupledStructure, public LinearisedStructure {
  public:
    VectorXd acceptedDisplacements() const override { return VectorXd::Ones(1); }
    VectorXd solve(const VectorXd& force) override { return displacements(force / stiffness); }
    LinearisedStructure* linearised() override { return this; }

    VectorXd acceptedUnknowns() const override { return VectorXd::Zero(1); }
    VectorXd residual(const VectorXd& d) override { return stiffness * d; }
    void linearise(const VectorXd&) override {}
    Eigen::MatrixXd responses(const Eigen::MatrixXd& b) override { return b / stiffness; }
    VectorXd displacements(const VectorXd& d) override { return VectorXd::Ones(1) + d; }
    Eigen::MatrixXd variations(const Eigen::MatrixXd& D) override { return D; }
    VectorXd loads(const VectorXd& force, const VectorXd&) override { return force; }
    VectorXd solveFor(const VectorXd& loads, const VectorXd&) override { return loads / stiffness; }

    static constexpr double stiffness = 1e12;
};

TEST_P(Acceptance, final_forces_that_have_not_converged_do_not_end_the_step_of_a_heavy_structure) {
    constexpr double tolerance = 1e-4;
    constexpr double notConverged = 1e-2; // momentum residual
    Immovable structure;
    CouplingOptions options;
    options.acceleration.type = GetParam();
    const auto method = makeCouplingMethod(options, tolerance, structure);
    const VectorXd force = VectorXd::Ones(1);
    method->predict(0.1);
    method->iterate(force, notConverged);
    ASSERT_TRUE(method->iterate(force, notConverged).converged);
    const CouplingIteration refused = method->accept(1.01 * force, tolerance);
    EXPECT_FALSE(refused.converged);
    // The change over the allowed 1e-3 of the force
    EXPECT_NEAR(refused.residual, tolerance * 0.01 / 1.01 / 1e-3, 1e-6 * tolerance);
    // The step goes on with these forces, which are still to be compared with the last ones
    EXPECT_FALSE(method->iterate(1.01 * force, notConverged).converged);
    ASSERT_TRUE(method->iterate(1.01 * force, notConverged).converged);
    EXPECT_TRUE(method->accept(1.01 * force, tolerance).converged);
    // In a flow that has converged the force does as well
    method->predict(0.1);
    method->iterate(force, 0.1 * tolerance);
    EXPECT_TRUE(method->accept(1.01 * force, tolerance).converged);
}

INSTANTIATE_TEST_SUITE_P(Methods, Acceptance, testing::Values("aitken", "iqnIls", "mvqn", "block"));

TEST(ExplicitAcceptance, explicit_coupling_accepts_whatever_the_residual) {
    ElasticTube tube(10, 10, 0.01);
    CouplingOptions options;
    options.acceleration.type = "explicit";
    const auto method = makeCouplingMethod(options, 1e-7, tube);
    tube.beginTimeStep();
    const VectorXd x = method->predict(tube.deltaT());
    EXPECT_TRUE(method->accept(tube.fluid(x), 1e-7).converged);
}

} // namespace
} // namespace tokay::coupling
