// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/timeIntegration/ImplicitStepper.hpp"
#include "igaStructure/timeIntegration/Springs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace tokay;
using namespace tokay::structure;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace {

double force(double u) {
    return 2 * u + u * u * u;
}

/// A spring under a load of t [N] whose equilibrium is not found in steps that are longer
/// than a limit, as long as they begin before a time. Notes the times that are tried.
class Reluctant {
  public:
    double longest = 0;
    double until = 1e9;
    std::vector<double> tried;

    ImplicitStepper& stepper(const TimeScheme& scheme, double minStep) {
        springs_.load = [](double t) { return t; };
        stepper_ = std::make_unique<ImplicitStepper>(springs_, scheme, newton, minStep);
        springs_.load = [this](double t) {
            tried.push_back(t);
            const double start = stepper_->state().time;
            const bool fails = start < until && t - start > longest * (1 + 1e-9);
            return fails ? NAN : t;
        };
        return *stepper_;
    }
    Springs& springs() { return springs_; }

    static inline const NewtonOptions newton{1e-12, 25};

  private:
    Springs springs_{1, force, [](double u) { return 2 + 3 * u * u; }};
    std::unique_ptr<ImplicitStepper> stepper_;
};

const TimeScheme statics = TimeScheme::quasiStatic();
const TimeScheme dynamics = TimeScheme::generalisedAlpha(0.8);

/// The motion at the end of steps to these times.
MotionState stepped(const std::vector<double>& times, const std::vector<double>& lengths) {
    Springs springs(1, force, [](double u) { return 2 + 3 * u * u; });
    springs.load = [](double t) { return t; };
    TimeIntegrator integrator(springs, dynamics, Reluctant::newton, 0);
    for (std::size_t k = 0; k < times.size(); ++k) {
        integrator.beginTimeStep(times[k], lengths[k]);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    return integrator.state();
}

} // namespace

TEST(ImplicitStepper, halves_a_step_until_it_succeeds_and_doubles_it_again) {
    Reluctant spring;
    spring.longest = 0.0625;
    spring.until = 0.05;
    ImplicitStepper& stepper = spring.stepper(statics, 1e-3);
    stepper.advance(1, 1);
    EXPECT_THAT(spring.tried, ElementsAre(1, 0.5, 0.25, 0.125, 0.0625, // in halves
                                          0.1875, 0.4375, 0.9375, 1)); // twice as long each
    EXPECT_EQ(stepper.state().time, 1);
    EXPECT_NEAR(force(stepper.state().displacement[0]), 1, 1e-11);
}

TEST(ImplicitStepper, part_that_fails_again_is_halved_again) {
    Reluctant spring;
    spring.longest = 0.25;
    ImplicitStepper& stepper = spring.stepper(statics, 0.25);
    stepper.advance(1, 1);
    EXPECT_THAT(spring.tried, ElementsAre(1, 0.5, 0.25, 0.75, 0.5, 1, 0.75, 1));
}

TEST(ImplicitStepper, moves_by_the_parts_that_it_has_taken) {
    Reluctant spring;
    spring.longest = 0.5;
    ImplicitStepper& stepper = spring.stepper(dynamics, 1e-3);
    stepper.advance(1, 1);
    const MotionState expected = stepped({0.5, 1}, {0.5, 0.5});
    EXPECT_EQ(stepper.state().displacement, expected.displacement);
    EXPECT_EQ(stepper.state().velocity, expected.velocity);
}

TEST(ImplicitStepper, parts_that_rounding_leaves_a_little_short_end_at_the_steps_end) {
    Reluctant spring;
    spring.longest = 0.15;
    ImplicitStepper& stepper = spring.stepper(dynamics, 1e-3);
    const std::vector<double> ends = {0.3, 0.3 + 0.3, 0.9, 1.2};
    for (const double end : ends) {
        spring.tried.clear();
        stepper.advance(end, 0.3);
        ASSERT_EQ(spring.tried.size(), 3) << end; // the whole, and two halves
        EXPECT_EQ(stepper.state().time, end);
    }
}

TEST(ImplicitStepper, steps_of_equal_length_are_the_time_integrators_own) {
    // Differences of these times differ by rounding: the length has to be the one given.
    Reluctant spring;
    spring.longest = 1;
    ImplicitStepper& stepper = spring.stepper(dynamics, 1e-3);
    std::vector<double> times;
    for (int k = 1; k <= 7; ++k) {
        times.push_back(0.1 * k);
        stepper.advance(times.back(), 0.1);
    }
    const MotionState expected = stepped(times, std::vector<double>(times.size(), 0.1));
    EXPECT_EQ(stepper.state().displacement, expected.displacement);
    EXPECT_EQ(stepper.state().velocity, expected.velocity);
}

TEST(ImplicitStepper, counts_iterations_of_all_parts_and_tells_the_last_residual) {
    Reluctant spring;
    spring.longest = 0.5;
    ImplicitStepper& stepper = spring.stepper(statics, 1e-3);
    const StepEffort effort = stepper.advance(1, 1);
    int expected = 0;
    TimeIntegrator integrator(spring.springs(), statics, Reluctant::newton, 0);
    spring.springs().load = [](double t) { return t; };
    for (const double time : {0.5, 1.0}) {
        integrator.beginTimeStep(time, 0.5);
        integrator.solve();
        integrator.acceptTimeStep();
        expected += integrator.nIterations();
    }
    EXPECT_EQ(effort.nIterations, expected);
    EXPECT_EQ(effort.residual, integrator.residuals().back());
}

TEST(ImplicitStepper, shortest_part_is_tried_and_no_shorter_one) {
    Reluctant spring;
    spring.longest = 0.2;
    EXPECT_THROW(spring.stepper(dynamics, 0.25).advance(1, 1), SolverError);
    EXPECT_THAT(spring.tried, ElementsAre(1, 0.5, 0.25));
    spring.tried.clear();
    EXPECT_THROW(spring.stepper(dynamics, 0.26).advance(1, 1), SolverError);
    EXPECT_THAT(spring.tried, ElementsAre(1, 0.5));
}

TEST(ImplicitStepper, names_no_limit_point_beyond_the_step_that_failed_nor_in_dynamics) {
    // 2 u - u^2 has its maximum 1 at u = 1.
    Springs arch(
        1, [](double u) { return 2 * u - u * u; }, [](double u) { return 2 - 2 * u; });
    arch.load = [](double t) { return t; };
    const auto failure = [&](const TimeScheme& scheme, int maxIterations) -> std::string {
        NewtonOptions newton{1e-12, maxIterations};
        ImplicitStepper stepper(arch, scheme, newton, 0.6);
        try {
            stepper.advance(0.6, 0.6);
            stepper.advance(1.2, 0.6);
        } catch (const SolverError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(failure(statics, 25), HasSubstr("limit point at t = 1,"));
    // One iteration finds no equilibrium, but there is one in the whole first step.
    EXPECT_THAT(failure(statics, 1), Not(HasSubstr("limit point")));
    arch.mass = 1e-6;
    EXPECT_THAT(failure(dynamics, 1),
                AllOf(HasSubstr("did not converge"), Not(HasSubstr("limit point"))));
}
