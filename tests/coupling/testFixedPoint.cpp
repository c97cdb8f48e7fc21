// SPDX-License-Identifier: GPL-3.0-or-later
#include "GivenSolution.hpp"
#include "LinearResponse.hpp"
#include "common/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

const double tolerance = 1e-6;

CouplingOptions iqnIls() {
    CouplingOptions options;
    options.acceleration.type = "iqnIls";
    return options;
}

LinearResponse exampleResponse() {
    return addedMass(VectorXd::LinSpaced(4, 0.5, 20));
}

/// Iterates to convergence, then accepts as a fluid does that stays where it
/// was in its last coupling iteration.
void runStep(CouplingMethod& method, const LinearResponse& response, double deltaT) {
    VectorXd x = method.predict(deltaT);
    for (int i = 0; i < 50; ++i) {
        const CouplingIteration iteration = method.iterate(response(x), 0);
        if (iteration.converged) {
            break;
        }
        x = iteration.x;
    }
    ASSERT_TRUE(method.statistics().converged);
    EXPECT_LT(method.accept(response(x)).residual, tolerance);
}

TEST(FixedPoint, converges_to_the_solution_of_the_coupled_problem) {
    const LinearResponse response = exampleResponse();
    GivenSolution driver(iqnIls(), tolerance, VectorXd::Zero(4));
    VectorXd x = driver->predict(0.1);
    CouplingIteration iteration;
    while (!iteration.converged) {
        iteration = driver->iterate(response(x), 0);
        if (!iteration.converged) {
            x = iteration.x;
        }
    }
    // x - solution = (1 - A)^-1 (xTilde - x), and |(1 - A)^-1| < 1 here.
    EXPECT_LT(response.error(x), 2 * tolerance);
}

TEST(FixedPoint, predicts_from_what_the_structure_accepted) {
    const LinearResponse response = exampleResponse();
    GivenSolution driver(iqnIls(), tolerance, VectorXd::Zero(4));
    runStep(*driver, response, 0.1);
    const VectorXd expected = 3 * response.solution(); // linear, the step twice as long
    EXPECT_LT((driver->predict(0.2) - expected).norm(), 10 * tolerance * expected.norm());
}

TEST(FixedPoint, a_rejected_step_leaves_no_trace) {
    const LinearResponse response = exampleResponse();
    GivenSolution driver(iqnIls(), tolerance, VectorXd::Zero(4));
    GivenSolution undisturbed(iqnIls(), tolerance, VectorXd::Zero(4));
    runStep(*driver, response, 0.1);
    runStep(*undisturbed, response, 0.1);
    const VectorXd x = driver->predict(0.4);
    driver->iterate(VectorXd::Constant(4, 1e6), 0);
    driver->iterate(VectorXd::Constant(4, -1e9), 0);
    driver->reject();
    EXPECT_EQ(driver->predict(0.1), undisturbed->predict(0.1));
    EXPECT_EQ(driver->iterate(2 * x, 0).x, undisturbed->iterate(2 * x, 0).x);
}

TEST(FixedPoint, final_residual_belongs_to_the_displacement_of_the_last_iteration) {
    GivenSolution driver(iqnIls(), tolerance, VectorXd::Zero(1));
    driver->predict(0.1);
    driver->iterate(VectorXd::Ones(1), 0); // proposes 0.1
    driver->iterate(VectorXd::Ones(1), 0); // was at 0.1, proposes something else
    EXPECT_NEAR(driver->accept(VectorXd::Ones(1)).residual, 0.9, 1e-15);
}

TEST(FixedPoint, accepts_a_step_without_any_iteration) {
    GivenSolution driver(iqnIls(), tolerance, VectorXd::Ones(1));
    driver->predict(0.1);
    EXPECT_EQ(driver->accept(VectorXd::Constant(1, 2)).residual, 0.5);
    EXPECT_EQ(driver->statistics().nIterations, 0);
}

TEST(FixedPoint, explicit_coupling_takes_one_iteration_and_does_not_move_on) {
    CouplingOptions options;
    options.acceleration.type = "explicit";
    GivenSolution driver(options, tolerance, VectorXd::Ones(1));
    driver->predict(0.1);
    const CouplingIteration iteration = driver->iterate(VectorXd::Constant(1, 2), 0);
    EXPECT_TRUE(iteration.converged);
    EXPECT_EQ(iteration.residual, 0);
    EXPECT_EQ(iteration.x[0], 1);
    EXPECT_EQ(driver->statistics().lastResidual, 0.5); // what it really was
    EXPECT_FALSE(driver->statistics().converged);
    driver->accept(VectorXd::Constant(1, 2));
    EXPECT_EQ(driver->predict(0.1)[0], 3);
}

TEST(FixedPoint, counts_iterations_and_residuals_of_each_step) {
    const LinearResponse response = exampleResponse();
    GivenSolution driver(iqnIls(), tolerance, VectorXd::Zero(4));
    runStep(*driver, response, 0.1);
    EXPECT_GE(driver->statistics().nIterations, 6); // four unknowns, and one to notice
    EXPECT_EQ(driver->statistics().firstResidual, 1);
    EXPECT_LT(driver->statistics().lastResidual, tolerance);
    EXPECT_GT(driver->statistics().nColumns, 0);
    driver->predict(0.1);
    EXPECT_EQ(driver->statistics().nIterations, 0);
}

TEST(FixedPoint, a_structural_solution_that_is_not_finite_is_an_error) {
    GivenSolution driver(iqnIls(), tolerance, VectorXd::Zero(3));
    driver->predict(0.1);
    const VectorXd xTilde(Eigen::Vector3d(1, 1, std::nan("")));
    EXPECT_THROW(driver->iterate(xTilde, 0), SolverError);
    EXPECT_THROW(driver->accept(xTilde), SolverError);
}

} // namespace
} // namespace tokay::coupling
