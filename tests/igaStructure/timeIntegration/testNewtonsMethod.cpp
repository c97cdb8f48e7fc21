// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/timeIntegration/Springs.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;
using testing::HasSubstr;

namespace {

NewtonOptions options(double tolerance, int maxIterations = 25, bool lineSearch = true,
                      double reuseContraction = 0) {
    return {tolerance, maxIterations, lineSearch, reuseContraction};
}

// A bar of neo-Hookean kind: stretch - 1/stretch, folded through itself below 0. The
// equation 'force = load' has a second solution there, of no meaning.
Springs foldableBar() {
    Springs bar(
        1, [](double u) { return 1 + u - 1 / (1 + u); },
        [](double u) { return 1 + 1 / ((1 + u) * (1 + u)); });
    bar.ratio = [](double u) { return 1 + u; };
    return bar;
}

// A spring that softens on both sides: Newton's method without a line search diverges
// from beyond 1.39.
Springs softening() {
    return {1, [](double u) { return std::atan(u); }, [](double u) { return 1 / (1 + u * u); }};
}

TimeIntegrator staticIntegrator(Springs& springs, const NewtonOptions& newton) {
    TimeIntegrator integrator(springs, TimeScheme::quasiStatic(), newton, 0);
    integrator.beginTimeStep(1, 1);
    return integrator;
}

VectorXd one(double value) {
    return VectorXd::Constant(1, value);
}

std::string failureOf(TimeIntegrator& integrator, const VectorXd& force) {
    try {
        integrator.solve(force);
    } catch (const SolverError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(NewtonsMethod, ends_with_the_first_residual_below_the_tolerance) {
    for (double tolerance = 1e-1; tolerance > 1e-12; tolerance *= 0.1) {
        Springs springs(
            1, [](double u) { return u + u * u * u; }, [](double u) { return 1 + 3 * u * u; });
        TimeIntegrator integrator = staticIntegrator(springs, options(tolerance));
        integrator.solve(one(10)); // u = 2
        const std::vector<double>& residuals = integrator.residuals();
        ASSERT_GE(residuals.size(), 2u);
        EXPECT_LE(residuals.back(), tolerance);
        EXPECT_GT(residuals[residuals.size() - 2], tolerance);
        EXPECT_EQ(integrator.nIterations(), static_cast<int>(residuals.size()) - 1);
    }
}

TEST(NewtonsMethod, line_search_converges_where_whole_updates_diverge) {
    Springs springs = softening();
    TimeIntegrator searching = staticIntegrator(springs, options(1e-10));
    searching.startFrom(one(3));
    EXPECT_NEAR(searching.solve(one(std::atan(0.1)))[0], 0.1, 1e-9);
    TimeIntegrator whole = staticIntegrator(springs, options(1e-10, 25, false));
    whole.startFrom(one(3));
    EXPECT_NE(failureOf(whole, one(std::atan(0.1))), "no error");
}

TEST(NewtonsMethod, line_search_goes_down_to_a_sixty_fourth_of_the_update) {
    Springs springs(
        1, [](double u) { return u; }, [](double) { return 1; });
    springs.ratio = [](double u) { return 1 - u / 0.0157; }; // 1/64 = 0.015625 is the first
    TimeIntegrator integrator = staticIntegrator(springs, options(1e-10, 1));
    EXPECT_THAT(failureOf(integrator, one(1)), HasSubstr("did not converge"));
    EXPECT_EQ(integrator.displacement()[0], 1.0 / 64);
}

TEST(NewtonsMethod, never_leaves_the_body_inside_out) {
    // u + 1 - 1/(u + 1) = -10: a stretch of sqrt(26) - 5, the other one is -5 - sqrt(26).
    const double stretch = std::sqrt(26.0) - 5;
    Springs bar = foldableBar();
    TimeIntegrator fresh = staticIntegrator(bar, options(1e-12, 50));
    EXPECT_NEAR(fresh.solve(one(-10))[0], stretch - 1, 1e-12);
    // The same with the tangent of a small load, whose update inverts and yet reduces the
    // residual.
    TimeIntegrator reusing = staticIntegrator(bar, options(1e-12, 200, true, 0.9));
    reusing.solve(one(1e-3));
    EXPECT_NEAR(reusing.solve(one(-10))[0], stretch - 1, 1e-12);
}

TEST(NewtonsMethod, starts_from_the_displacement_that_it_is_told) {
    Springs springs = softening();
    TimeIntegrator integrator = staticIntegrator(springs, options(1e-10));
    const VectorXd solution = integrator.solve(one(1));
    EXPECT_GT(integrator.nIterations(), 1);
    integrator.beginTimeStep(1, 1);
    integrator.startFrom(solution);
    EXPECT_EQ(integrator.solve(one(1)), solution);
    EXPECT_EQ(integrator.nIterations(), 0);
}

TEST(NewtonsMethod, ends_where_the_residual_is_not_finite) {
    Springs springs(
        1, [](double u) { return u < 0.5 ? u : NAN; }, [](double) { return 1; });
    springs.ratio = [](double) { return 1; };
    TimeIntegrator integrator = staticIntegrator(springs, options(1e-10, 25, false));
    EXPECT_THAT(failureOf(integrator, one(1)), HasSubstr("the residual is not finite"));
    EXPECT_EQ(integrator.residuals().size(), 2u);
}

TEST(NewtonsMethod, solution_of_a_linear_structure_that_is_not_finite_is_refused) {
    Springs springs(
        1, [](double u) { return 1e-200 * u; }, [](double) { return 1e-200; });
    springs.linear = true;
    TimeIntegrator integrator = staticIntegrator(springs, options(1e-10));
    EXPECT_THAT(failureOf(integrator, one(1e200)), HasSubstr("the solution is not finite"));
}

TEST(NewtonsMethod, unknown_without_stiffness_is_named_by_control_point_and_component) {
    Springs springs(
        4, [](double u) { return u; }, [](double) { return 1; });
    springs.factor = [](int k) { return k == 3 ? -1 : 1; };
    TimeIntegrator integrator = staticIntegrator(springs, options(1e-10));
    EXPECT_THAT(failureOf(integrator, VectorXd::Ones(4)),
                HasSubstr("at control point 1, component 1"));
    springs.factor = [](int k) { return k == 2 ? -1 : 1; };
    EXPECT_THAT(failureOf(integrator, VectorXd::Ones(4)),
                HasSubstr("at control point 1, component 0"));
}

namespace {

// Forces that come with a noise of rounding error, as sums over elements do: of a part in
// 1e16 of the largest force, here of the stiffest of two springs.
Springs noisy() {
    Springs springs(
        2,
        [](double u) {
            const double epsilon = std::numeric_limits<double>::epsilon();
            return 1e6 * (u + 0.1 * u * u) + 1e6 * 0.2 * epsilon * std::sin(1e18 * u);
        },
        [](double u) { return 1e6 * (1 + 0.2 * u); });
    springs.load = [](double t) { return t; };
    return springs;
}

} // namespace

TEST(NewtonsMethod, ends_at_the_rounding_error_of_internal_forces) {
    Springs springs = noisy();
    springs.load = [](double t) { return 1e6 * t; };
    TimeIntegrator integrator = staticIntegrator(springs, options(1e-30));
    EXPECT_EQ(failureOf(integrator, VectorXd::Zero(2)), "no error");
}

TEST(NewtonsMethod, ends_at_the_rounding_error_of_inertia) {
    // Accelerations are differences of displacements of order 1 over the step squared.
    Springs springs(
        2, [](double u) { return u + 0.1 * u * u; }, [](double u) { return 1 + 0.2 * u; });
    TimeIntegrator integrator(springs, TimeScheme::newmark(0.25, 0.5), options(1e-30), 0);
    MotionState state = integrator.state();
    state.displacement.setConstant(1.0 / 3);
    state.acceleration.setConstant(-1.0 / 3);
    state.velocity.setConstant(0.7);
    integrator.restore(state, {});
    integrator.beginTimeStep(1e-6, 1e-6);
    EXPECT_EQ(failureOf(integrator, VectorXd::Zero(2)), "no error");
}

namespace {

double firstResidual(TimeIntegrator& integrator, double start, double force) {
    integrator.startFrom(one(start));
    integrator.solve(one(force));
    return integrator.residuals().front();
}

} // namespace

TEST(NewtonsMethod, residual_is_relative_to_the_largest_of_load_internal_force_and_inertia) {
    Springs springs(
        1, [](double u) { return u + 1e-3 * u * u; }, [](double u) { return 1 + 2e-3 * u; });
    TimeIntegrator atRest = staticIntegrator(springs, options(1e-10));
    EXPECT_NEAR(firstResidual(atRest, 0, 5), 1, 1e-12);   // the load alone
    EXPECT_NEAR(firstResidual(atRest, 5, 1e-6), 1, 1e-5); // the internal force alone
    EXPECT_NEAR(firstResidual(atRest, 5, 10), 0.5, 1e-2); // 10 - 5 of 10
    TimeIntegrator inMotion(springs, TimeScheme::newmark(0.25, 0.5), options(1e-10), 0);
    inMotion.beginTimeStep(1e-3, 1e-3);
    // Moved by 1 in a millisecond: 4e6 N of inertia.
    EXPECT_NEAR(firstResidual(inMotion, 1, 1), 1, 1e-5);
}

TEST(NewtonsMethod, force_that_is_not_finite_is_told_of_any_structure) {
    for (const bool isLinear : {true, false}) {
        Springs springs(
            1, [](double u) { return u; }, [](double) { return 1; });
        springs.linear = isLinear;
        TimeIntegrator integrator = staticIntegrator(springs, options(1e-10));
        EXPECT_THAT(failureOf(integrator, one(NAN)),
                    HasSubstr("a force on the structure is not finite at time 1 s"));
    }
}
