// SPDX-License-Identifier: GPL-3.0-or-later
#include "LinearResponse.hpp"
#include "coupling/fixedPoint/ConstantRelaxation.hpp"
#include "coupling/fixedPoint/IqnIls.hpp"

#include <gtest/gtest.h>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

/// Without guards and filter: the method of the textbook.
IqnIls::Options bare() {
    IqnIls::Options options;
    options.signalToNoise = 0;
    options.maxStep = 0;
    options.keepFraction = 0;
    options.filterLimit = 0;
    return options;
}

VectorXd strongAddedMass() {
    VectorXd ratios(5);
    ratios << 1000, 50, 10, 1, 0.1;
    return ratios;
}

TEST(IqnIls, solves_a_linear_problem_of_n_unknowns_in_n_plus_one_iterations) {
    for (const int n : {1, 2, 5, 12}) {
        std::srand(static_cast<unsigned>(n));
        const LinearResponse response{Eigen::MatrixXd::Random(n, n), VectorXd::Random(n)};
        IqnIls method(bare());
        // Rounding errors grow with the condition of n differences (here 1e4).
        EXPECT_LT(response.error(iterated(method, response, n + 1)), 1e-9) << n << " unknowns";
    }
}

TEST(IqnIls, needs_all_of_them) {
    const LinearResponse response = addedMass(strongAddedMass());
    IqnIls method(bare());
    EXPECT_GT(response.error(iterated(method, response, 4)), 1e-6);
}

TEST(IqnIls, converges_with_its_default_guards_where_relaxation_diverges) {
    const LinearResponse response = addedMass(strongAddedMass());
    ConstantRelaxation relaxation({0.1});
    EXPECT_GT(response.error(iterated(relaxation, response, 20)), 1e10);
    IqnIls method{IqnIls::Options()};
    EXPECT_LT(response.error(iterated(method, response, 20)), 1e-8);
}

TEST(IqnIls, one_iteration_is_enough_in_a_later_step_of_a_linear_problem) {
    LinearResponse response = addedMass(strongAddedMass());
    IqnIls method(bare());
    iterated(method, response, 6);
    method.acceptTimeStep();
    response.b.reverseInPlace(); // another step: other loads, the same response
    EXPECT_LT(response.error(iterated(method, response, 1)), 1e-9);
}

TEST(IqnIls, reuse_ends_after_the_steps_asked_for) {
    const LinearResponse response = addedMass(strongAddedMass());
    IqnIls::Options options = bare();
    options.reusedTimeSteps = 2;
    IqnIls method(options);
    iterated(method, response, 4);
    EXPECT_EQ(method.nColumns(), 3);
    for (const int expected : {3, 3, 0}) {
        method.acceptTimeStep();
        method.beginTimeStep();
        EXPECT_EQ(method.nColumns(), expected);
    }
}

TEST(IqnIls, keeps_only_the_newest_columns) {
    const LinearResponse response = addedMass(strongAddedMass());
    IqnIls::Options options = bare();
    options.maxColumns = 2;
    IqnIls method(options);
    iterated(method, response, 5);
    EXPECT_EQ(method.nColumns(), 2);
}

TEST(IqnIls, a_rejected_step_teaches_nothing) {
    const LinearResponse response = addedMass(strongAddedMass());
    IqnIls method(bare());
    iterated(method, response, 3);
    method.acceptTimeStep();
    iterated(method, response, 3);
    EXPECT_GT(method.nColumns(), 2);
    method.rejectTimeStep();
    EXPECT_EQ(method.nColumns(), 2);
}

TEST(IqnIls, a_move_below_the_fluids_own_error_teaches_nothing) {
    // |Δx|/|xTilde| is 0.1 here, |Δx|/|x| a half, and signalToNoise 3.
    const auto nColumnsAtResidual = [](double fluidResidual) {
        IqnIls method{IqnIls::Options()};
        method.beginTimeStep();
        method.next(VectorXd::Constant(2, 0.1), VectorXd::Constant(2, 1), fluidResidual);
        method.next(VectorXd::Constant(2, 0.2), VectorXd::Constant(2, 1), fluidResidual);
        return method.nColumns();
    };
    EXPECT_EQ(nColumnsAtResidual(0.03), 1);
    EXPECT_EQ(nColumnsAtResidual(0.04), 0);
}

TEST(IqnIls, drift_of_the_fluid_at_the_same_displacement_teaches_nothing) {
    IqnIls method(bare());
    method.beginTimeStep();
    method.next(VectorXd::Ones(2), VectorXd::Constant(2, 2), 0);
    method.next(VectorXd::Ones(2), VectorXd::Constant(2, 3), 0);
    EXPECT_EQ(method.nColumns(), 0);
}

TEST(IqnIls, step_is_limited_to_a_multiple_of_the_residual) {
    // xTilde = 0.9 x + 1: the secant alone would step 10 residuals far.
    const LinearResponse response{Eigen::MatrixXd::Constant(1, 1, 0.9), VectorXd::Ones(1)};
    IqnIls method{IqnIls::Options()};
    const VectorXd x1 = iterated(method, response, 1);
    const VectorXd x2 = method.next(x1, response(x1), 0);
    const double residual = (response(x1) - x1).norm();
    EXPECT_NEAR((x2 - x1).norm(), 2 * residual, 1e-13);
    IqnIls unlimited(bare());
    EXPECT_LT(response.error(iterated(unlimited, response, 2)), 1e-13);
}

TEST(IqnIls, small_columns_are_dropped_at_the_end_of_their_step) {
    const auto nKept = [](double keepFraction) {
        IqnIls::Options options = bare();
        options.keepFraction = keepFraction;
        IqnIls method(options);
        method.beginTimeStep();
        VectorXd x = VectorXd::Zero(2);
        method.next(x, VectorXd::Zero(2), 0);
        for (const double length : {1.0, 0.04}) { // two columns, in two directions
            const VectorXd w = VectorXd::Constant(2, 1).cwiseProduct(
                length == 1.0 ? VectorXd::Unit(2, 0) : VectorXd(0.04 * VectorXd::Unit(2, 1)));
            x += 2 * w;
            method.next(x, x / 2, 0);
        }
        EXPECT_EQ(method.nColumns(), 2);
        method.acceptTimeStep();
        return method.nColumns();
    };
    EXPECT_EQ(nKept(0.05), 1);
    EXPECT_EQ(nKept(0.03), 2);
}

TEST(IqnIls, columns_of_a_step_are_compared_with_its_own_only) {
    IqnIls::Options options = bare();
    options.keepFraction = 0.05;
    IqnIls method(options);
    VectorXd x = VectorXd::Zero(2);
    for (const double length : {100.0, 1.0}) { // the second step's are all below 5 % of 100
        method.beginTimeStep();
        method.next(x, x / 2, 0);
        x += length * VectorXd::Unit(2, length == 100.0 ? 0 : 1);
        method.next(x, x / 2, 0);
        method.acceptTimeStep();
    }
    EXPECT_EQ(method.nColumns(), 2);
}

} // namespace
} // namespace tokay::coupling
