// SPDX-License-Identifier: GPL-3.0-or-later
#include "LinearResponse.hpp"
#include "coupling/fixedPoint/Aitken.hpp"
#include "coupling/fixedPoint/ConstantRelaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

LinearResponse scalarResponse(double slope) {
    return {Eigen::MatrixXd::Constant(1, 1, slope), VectorXd::Constant(1, 1)};
}

TEST(ConstantRelaxation, converges_at_the_rate_of_theory) {
    // The error is multiplied by 1 - relaxation (1 - slope) each time.
    const LinearResponse response = scalarResponse(-3);
    ConstantRelaxation relaxation({0.2});
    const double rate = std::abs(1 - 0.2 * (1 + 3));
    EXPECT_NEAR(response.error(iterated(relaxation, response, 10)), std::pow(rate, 10),
                1e-13); // rounding errors of values of size one
}

TEST(ConstantRelaxation, diverges_where_the_added_mass_is_too_large) {
    const LinearResponse response = scalarResponse(-3);
    ConstantRelaxation relaxation({0.6}); // |1 - 0.6 * 4| > 1
    EXPECT_GT(response.error(iterated(relaxation, response, 20)), 100);
}

TEST(Aitken, is_exact_for_one_unknown_that_responds_linearly) {
    for (const double slope : {-3.0, -0.5, 0.2, -40.0}) {
        const LinearResponse response = scalarResponse(slope);
        Aitken aitken{Aitken::Options()};
        EXPECT_LT(response.error(iterated(aitken, response, 2)), 1e-13) << "slope " << slope;
    }
}

TEST(Aitken, stays_within_its_bounds) {
    Aitken::Options options;
    options.minRelaxation = 0.05;
    options.maxRelaxation = 0.4;
    Aitken aitken(options);
    iterated(aitken, scalarResponse(-99), 2); // wants 0.01
    EXPECT_EQ(aitken.relaxation(), 0.05);
    iterated(aitken, scalarResponse(0), 2); // wants 1
    EXPECT_EQ(aitken.relaxation(), 0.4);
}

TEST(Aitken, starts_a_step_no_bolder_than_its_first) {
    Aitken aitken{Aitken::Options()};
    iterated(aitken, scalarResponse(0), 2);
    EXPECT_NEAR(aitken.relaxation(), 1, 1e-13);
    aitken.beginTimeStep();
    EXPECT_EQ(aitken.relaxation(), Aitken::Options().initialRelaxation);
}

TEST(Aitken, starts_a_step_as_cautiously_as_the_last_one_ended_unless_that_is_rejected) {
    Aitken aitken{Aitken::Options()};
    iterated(aitken, scalarResponse(-39), 2);
    EXPECT_NEAR(aitken.relaxation(), 1 / 40.0, 1e-13); // exact for that slope
    aitken.acceptTimeStep();
    // The first move of the next step: of a fixed point at 1 / 40 a fortieth of the residual.
    const VectorXd first = iterated(aitken, scalarResponse(-39), 1);
    EXPECT_NEAR(first[0], 1 / 40.0, 1e-13);
    aitken.rejectTimeStep();
    aitken.beginTimeStep();
    EXPECT_EQ(aitken.relaxation(), Aitken::Options().initialRelaxation);
}

TEST(Aitken, a_residual_that_does_not_change_leaves_the_factor) {
    Aitken aitken{Aitken::Options()};
    aitken.beginTimeStep();
    const VectorXd x = VectorXd::Zero(1);
    aitken.next(x, VectorXd::Ones(1), 0);
    EXPECT_EQ(aitken.next(x, VectorXd::Ones(1), 0)[0], Aitken::Options().initialRelaxation);
}

TEST(Aitken, drift_of_the_fluid_at_the_same_displacement_leaves_the_factor) {
    Aitken aitken{Aitken::Options()};
    aitken.beginTimeStep();
    const VectorXd x = VectorXd::Zero(1);
    aitken.next(x, VectorXd::Ones(1), 0);
    aitken.next(x, VectorXd::Constant(1, 0.5), 0);
    EXPECT_EQ(aitken.relaxation(), Aitken::Options().initialRelaxation);
}

TEST(Aitken, takes_its_smallest_factor_where_a_step_ahead_has_increased_the_residual) {
    // xTilde = 2 x + 1: its fixed point -1 lies behind, which no factor above 0 leads to.
    Aitken aitken{Aitken::Options()};
    iterated(aitken, scalarResponse(2), 2);
    EXPECT_EQ(aitken.relaxation(), Aitken::Options().minRelaxation);
}

} // namespace
} // namespace tokay::coupling
