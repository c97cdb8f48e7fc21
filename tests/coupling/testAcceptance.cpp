// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElasticTube.hpp"
#include "coupling/couplingMethods.hpp"

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
