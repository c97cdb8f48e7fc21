// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/timeIntegration/ArcLength.hpp"
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/SpringChain.hpp"
#include "igaStructure/timeIntegration/SubsteppedIntegrator.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"
#include "igaStructure/timeIntegration/supportRates.hpp"

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

namespace {

using Motion = SpringChain::Motion;

const NewtonOptions tight{1e-13, 25, true};
constexpr double deltaT = 0.05;

template <class Integrator>
void advance(Integrator& integrator, int nSteps) {
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(step * deltaT, deltaT);
        integrator.solve();
        integrator.acceptTimeStep();
    }
}

// The last of three bodies is the support.
SpringChain threeBodies(const Motion& motion) {
    return SpringChain({std::nullopt, std::nullopt, motion});
}

class MovingSupports : public testing::TestWithParam<double> {
  protected:
    SpringChain chain(const Motion& motion) const {
        SpringChain chain = threeBodies(motion);
        chain.cubic = GetParam();
        return chain;
    }
};
INSTANTIATE_TEST_SUITE_P(Cubic, MovingSupports, testing::Values(0.0, 300.0));

} // namespace

TEST_P(MovingSupports, carry_an_unloaded_structure_rigidly_in_a_static_analysis) {
    SpringChain chain = this->chain([](double t) { return 3 * t * t - t; });
    TimeIntegrator integrator(chain, TimeScheme::quasiStatic(), tight, 0);
    advance(integrator, 4);
    // Of one solution each, and Newton's tolerance.
    EXPECT_LT((integrator.state().displacement - VectorXd::Constant(3, 0.12 - 0.2)).norm(), 1e-11);
    EXPECT_EQ(integrator.state().displacement[2], 3 * 0.2 * 0.2 - 0.2);
}

TEST_P(MovingSupports, carry_a_structure_rigidly_whose_loads_accelerate_it_as_they) {
    SpringChain chain = this->chain([](double t) { return 0.5 * 3 * t * t; });
    chain.load = [&](double) { return 3 * chain.mass; };
    // Constant acceleration is exact for every scheme of the family, and of a support
    // under the same load nothing is asked.
    for (const double radius : {0.0, 0.8, 1.0}) {
        TimeIntegrator integrator(chain, TimeScheme::generalisedAlpha(radius), tight, 0);
        advance(integrator, 20);
        EXPECT_LT((integrator.state().displacement - VectorXd::Constant(3, 1.5)).norm(), 1e-10);
        EXPECT_LT((integrator.state().velocity - VectorXd::Constant(3, 3)).norm(), 1e-9);
        EXPECT_LT(integrator.state().reaction.norm(), 1e-8);
    }
}

TEST(MovingSupport, excites_a_body_as_the_closed_form_says) {
    // m u'' + k (u - d) = 0 with d = a t^2/2 from rest: u = d - (a m/k) (1 - cos w t).
    const double acceleration = 2;
    const auto error = [&](const TimeScheme& scheme, int nSteps) {
        SpringChain chain({std::nullopt, [&](double t) { return 0.5 * acceleration * t * t; }});
        TimeIntegrator integrator(chain, scheme, tight, 0);
        for (int step = 1; step <= nSteps; ++step) {
            integrator.beginTimeStep(step * 1.0 / nSteps, 1.0 / nSteps);
            integrator.solve();
            integrator.acceptTimeStep();
        }
        const double omega = std::sqrt(chain.stiffness / chain.mass);
        return integrator.state().displacement[0] -
               (0.5 * acceleration - acceleration / (omega * omega) * (1 - std::cos(omega)));
    };
    for (const double radius : {0.5, 1.0}) {
        const TimeScheme scheme = TimeScheme::generalisedAlpha(radius);
        // Of second order: halving the step quarters the error, up to the next order.
        EXPECT_NEAR(std::log2(error(scheme, 200) / error(scheme, 400)), 2, 0.02);
    }
}

TEST_P(MovingSupports, do_the_work_that_the_trapezoidal_rule_keeps) {
    // The motion begins with a velocity: an impact on the support's own mass.
    SpringChain chain = this->chain([](double t) { return 0.1 * std::sin(6 * t); });
    chain.damping = 0.7;
    chain.sharedMass = 0.4;
    TimeIntegrator integrator(chain, TimeScheme::newmark(0.25, 0.5), tight, 0);
    advance(integrator, 40);
    const Energies& energies = integrator.energies();
    const double balance =
        energies.kinetic + energies.strain + energies.dampingWork - energies.externalWork;
    ASSERT_GT(energies.externalWork, 0.05);
    // Exact with linear springs; cubic ones are off by the square of the time step.
    EXPECT_NEAR(balance, 0, (GetParam() == 0 ? 1e-11 : 2e-2) * energies.externalWork);
}

TEST_P(MovingSupports, begin_with_the_rates_of_their_motion) {
    SpringChain chain = this->chain([](double t) { return 0.3 * t + 0.2 * t * t; });
    TimeIntegrator integrator(chain, TimeScheme::newmark(0.25, 0.5), tight, 0);
    integrator.startSupports(deltaT);
    // A parabola is exact but for the rounding of differences over 1e-2 of a step.
    EXPECT_NEAR(integrator.state().velocity[2], 0.3, 1e-12);
    EXPECT_NEAR(integrator.state().acceleration[2], 0.4, 1e-7);
    EXPECT_NEAR(integrator.energies().externalWork, 0.5 * chain.mass * 0.09, 1e-12);
}

TEST_P(MovingSupports, begin_with_the_rates_of_a_motion_that_is_no_polynomial) {
    SpringChain chain = this->chain([](double t) { return 0.1 * std::sin(6 * t); });
    TimeIntegrator integrator(chain, TimeScheme::newmark(0.25, 0.5), tight, 0);
    integrator.startSupports(deltaT);
    // The cubic over a thirtieth of the step: w h below 0.01, to the third and second power.
    EXPECT_NEAR(integrator.state().velocity[2], 0.6, 0.6 * 1e-6);
    EXPECT_NEAR(integrator.state().acceleration[2], 0, 3.6 * 1e-4);
}

TEST_P(MovingSupports, are_at_rest_in_the_energies_of_a_static_analysis) {
    SpringChain chain = this->chain([](double t) { return 3 * t * t - t; });
    TimeIntegrator integrator(chain, TimeScheme::quasiStatic(), tight, 0);
    advance(integrator, 4);
    EXPECT_EQ(integrator.state().acceleration.norm(), 0);
    EXPECT_EQ(integrator.state().velocity.norm(), 0);
    EXPECT_EQ(integrator.energies().kinetic, 0);
}

TEST_P(MovingSupports, react_to_what_they_move) {
    SpringChain chain = this->chain([](double t) { return 0.1 * t * t; });
    chain.load = [](double t) { return 5 * t; };
    TimeIntegrator atRest(chain, TimeScheme::quasiStatic(), tight, 0);
    advance(atRest, 3);
    // The sum of three loads, to Newton's tolerance.
    EXPECT_NEAR(atRest.state().reaction[2], -3 * 5 * 0.15, 1e-11);
    EXPECT_EQ(atRest.state().reaction.head(2).norm(), 0);
    // Newton's second law for the mean over each step, as the scheme weighs it.
    const TimeScheme scheme = TimeScheme::generalisedAlpha(0.6);
    TimeIntegrator inMotion(chain, scheme, tight, 0);
    inMotion.startSupports(deltaT);
    MotionState before = inMotion.state();
    for (int step = 1; step <= 10; ++step) {
        inMotion.beginTimeStep(step * deltaT, deltaT);
        inMotion.solve();
        inMotion.acceptTimeStep();
        const MotionState& after = inMotion.state();
        const double force = scheme.alphaF * (before.force + before.reaction).sum() +
                             (1 - scheme.alphaF) * (after.force + after.reaction).sum();
        const double acceleration = scheme.alphaM * before.acceleration.sum() +
                                    (1 - scheme.alphaM) * after.acceleration.sum();
        EXPECT_NEAR(force, chain.mass * acceleration, 1e-11 * std::abs(after.force.sum()));
        before = after;
    }
}

TEST_P(MovingSupports, are_followed_in_coupled_runs_too) {
    SpringChain chain = this->chain([](double t) { return 0.4 * t * t; });
    const TimeScheme scheme = TimeScheme::generalisedAlpha(0.8);
    TimeIntegrator whole(chain, scheme, tight, 0);
    TimeIntegrator parts(chain, scheme, tight, 0);
    advance(whole, 3);
    advance(parts, 3);
    whole.beginTimeStep(4 * deltaT, deltaT);
    parts.beginTimeStep(4 * deltaT, deltaT);
    const VectorXd force{{2.0, -1.0, 0.0}};
    whole.solve(force);
    // Newton's method from outside, from a displacement that supports have left.
    VectorXd d = parts.state().displacement;
    for (int k = 0; k < 12; ++k) {
        parts.linearise(d);
        d = parts.displacement() + parts.responses(force - parts.requiredForce(d));
    }
    EXPECT_LT((d - whole.displacement()).norm(), 1e-11);
    EXPECT_LT((parts.requiredForce(d) - force).norm(), 1e-9);
    const VectorXd reaction = whole.reaction();
    EXPECT_NEAR(parts.reaction()[2], reaction[2], 1e-8 * std::abs(reaction[2]));
    // Supports are where they are, whatever is asked for.
    d[2] += 1;
    EXPECT_LT((parts.requiredForce(d) - force).norm(), 1e-9);
}

TEST_P(MovingSupports, move_in_each_substep) {
    SpringChain chain = this->chain([](double t) { return 0.1 * std::sin(6 * t); });
    const TimeScheme scheme = TimeScheme::newmark(0.25, 0.5);
    SubsteppedIntegrator substeps(chain, scheme, tight, 0, 4);
    for (int step = 1; step <= 3; ++step) {
        substeps.beginTimeStep(4 * step * deltaT, 4 * deltaT);
        substeps.solve(VectorXd::Zero(3));
        substeps.acceptTimeStep();
    }
    TimeIntegrator steps(chain, scheme, tight, 0);
    advance(steps, 12);
    EXPECT_LT((substeps.state().displacement - steps.state().displacement).norm(), 1e-11);
    EXPECT_LT((substeps.state().reaction - steps.state().reaction).norm(), 1e-8);
}

TEST_P(MovingSupports, reaction_jumps_with_the_force_between_steps_of_substeps) {
    SpringChain chain = this->chain([](double t) { return 0.1 * t * t; });
    chain.sharedMass = 0.4;
    SubsteppedIntegrator substeps(chain, TimeScheme::newmark(0.25, 0.5), tight, 0, 3);
    const VectorXd force{{2.0, -1.0, 3.0}}; // on the support too
    for (int step = 1; step <= 3; ++step) {
        substeps.beginTimeStep(step * deltaT, deltaT);
        substeps.solve(step * step * force);
        substeps.acceptTimeStep();
        // Newton's second law for all bodies: springs act between them.
        const MotionState& state = substeps.state();
        const double inertia = (chain.massMatrix() * state.acceleration).sum();
        EXPECT_NEAR(state.force.sum() + state.reaction.sum(), inertia, 1e-9 * std::abs(inertia));
        EXPECT_EQ(state.force, step * step * force);
    }
}

TEST_P(MovingSupports, go_on_from_a_saved_state) {
    SpringChain chain = this->chain([](double t) { return 0.1 * std::sin(6 * t); });
    const TimeScheme scheme = TimeScheme::generalisedAlpha(0.8);
    TimeIntegrator whole(chain, scheme, tight, 0);
    advance(whole, 5);
    TimeIntegrator later(chain, scheme, tight, 0);
    later.restore(whole.state(), whole.energies());
    for (TimeIntegrator* integrator : {&whole, &later}) {
        integrator->beginTimeStep(6 * deltaT, deltaT);
        integrator->solve();
        integrator->acceptTimeStep();
    }
    EXPECT_EQ(whole.state().displacement, later.state().displacement);
    EXPECT_EQ(whole.state().reaction, later.state().reaction);
    EXPECT_EQ(whole.energies().externalWork, later.energies().externalWork);
}

TEST_P(MovingSupports, move_an_explicit_structure_as_an_implicit_one) {
    SpringChain chain = this->chain([](double t) { return 0.1 * t * t * (1 + t); });
    ExplicitIntegrator centralDifferences(chain, 0);
    TimeIntegrator implicit(chain, TimeScheme::generalisedAlpha(0.5), tight, 0);
    constexpr double step = 1e-3;
    for (int k = 1; k <= 500; ++k) {
        centralDifferences.advance(k * step, step);
        implicit.beginTimeStep(k * step, step);
        implicit.solve();
        implicit.acceptTimeStep();
    }
    const MotionState& found = centralDifferences.state();
    const MotionState& expected = implicit.state();
    // Both are of second order: (w dt)^2/12 with w below 10 1/s.
    EXPECT_LT((found.displacement - expected.displacement).norm(),
              1e-5 * expected.displacement.norm());
    EXPECT_LT((found.velocity - expected.velocity).norm(), 1e-4 * expected.velocity.norm());
    // A support's acceleration is of first order in the scheme: off by its jerk times the step.
    EXPECT_NEAR(found.reaction[2], expected.reaction[2], 1e-3 * expected.reaction[2]);
    const Energies energies = centralDifferences.energies();
    EXPECT_NEAR(energies.kinetic + energies.strain, energies.externalWork,
                1e-4 * energies.externalWork);
}

namespace {

/// A chain whose lumped mass has entries between neighbours, as that of joined beams has.
class CoupledMasses : public SpringChain {
  public:
    using SpringChain::SpringChain;
    SparseMatrix lumpedMassMatrix() const override { return massMatrix(); }
};

/// Central differences from the trapezoidal rule after 500 steps of 1 ms, relative to its
/// displacement.
double explicitMinusImplicit(StructuralModel& model) {
    ExplicitIntegrator centralDifferences(model, 0);
    TimeIntegrator trapezoidalRule(model, TimeScheme::newmark(0.25, 0.5), tight, 0);
    constexpr double step = 1e-3;
    for (int k = 1; k <= 500; ++k) {
        centralDifferences.advance(k * step, step);
        trapezoidalRule.beginTimeStep(k * step, step);
        trapezoidalRule.solve();
        trapezoidalRule.acceptTimeStep();
    }
    const VectorXd& expected = trapezoidalRule.state().displacement;
    return (centralDifferences.state().displacement - expected).norm() / expected.norm();
}

} // namespace

TEST(MovingSupport, moves_masses_that_are_coupled_with_it_in_explicit_steps_too) {
    CoupledMasses chain({std::nullopt, [](double t) { return 0.1 * t * t * (1 + t); }});
    chain.sharedMass = 1.5; // of 2
    // The support's acceleration lags by a jerk times the step, 0.6 of 0.2 m/s^2 a second.
    EXPECT_LT(explicitMinusImplicit(chain), 3e-3);
}

TEST(MovingSupport, is_followed_by_the_path_of_arc_length) {
    // Between two supports that part, a cubic chain stretches evenly.
    SpringChain chain(
        {[](double) { return 0.0; }, std::nullopt, [](double t) { return t * (1 + t); }});
    chain.cubic = 300;
    ArcLength path(chain, tight, EquilibriumPath{100, 4}, 0.1, 1);
    while (path.state().time < 1) {
        path.advance();
        const double time = path.state().time;
        const double end = time * (1 + time);
        EXPECT_NEAR(path.state().displacement[1], 0.5 * end, 1e-9);
        EXPECT_NEAR(path.state().displacement[2], end, 1e-12);
        EXPECT_NEAR(path.state().reaction[2],
                    0.5 * end * chain.stiffness + std::pow(0.5 * end, 3) * chain.cubic, 1e-6);
    }
}

TEST(MovingSupport, has_exact_rates_in_cubic_motions_on_either_side_of_a_time) {
    SpringChain chain = threeBodies([](double t) { return 2 - 3 * t + 5 * t * t - 7 * t * t * t; });
    const double t = 0.3;
    for (const double interval : {0.2, -0.2}) {
        const SupportRates rates = supportRates(chain, t, interval);
        // Rounding of numbers of order 1 over a third of the interval, and over its square.
        EXPECT_NEAR(rates.velocity[2], -3 + 10 * t - 21 * t * t, 1e-13);
        EXPECT_NEAR(rates.acceleration[2], 10 - 42 * t, 1e-12);
        EXPECT_EQ(rates.velocity.head(2).norm() + rates.acceleration.head(2).norm(), 0);
    }
}

TEST(MovingSupport, that_starts_within_rounding_of_rest_is_accepted) {
    const auto start = [](double distance) {
        SpringChain chain = threeBodies([=](double t) { return distance + t; });
        requireSupportsAtRest(chain, 0); // size 3
    };
    EXPECT_NO_THROW(start(-1e-12));
    EXPECT_THROW(start(-1e-11), InputError);
}

TEST(MovingSupport, that_is_displaced_at_the_start_is_refused_in_dynamics) {
    SpringChain chain = threeBodies([](double t) { return 0.5 + t; });
    const auto hint = testing::ThrowsMessage<InputError>(
        testing::AllOf(testing::HasSubstr("0.5 m at the start"), testing::HasSubstr("static")));
    EXPECT_THAT([&] { TimeIntegrator(chain, TimeScheme::newmark(0.25, 0.5), tight, 0); }, hint);
    EXPECT_THAT([&] { ExplicitIntegrator(chain, 0); }, hint);
    EXPECT_NO_THROW(TimeIntegrator(chain, TimeScheme::quasiStatic(), tight, 0));
}

namespace {

constexpr double share = 0.6; // u_2 = 0.6 u_1 + d(t)

double offset(double t) {
    return 0.3 * t * t;
}

// A support at rest, a free body, and one that depends on it.
SpringChain dependentChain() {
    SpringChain chain({[](double) { return 0.0; }, std::nullopt, offset});
    SparseMatrix dependence(3, 3);
    dependence.insert(1, 1) = 1;
    dependence.insert(2, 1) = share;
    chain.dependence = dependence;
    chain.load = [](double t) { return 4 * t; };
    return chain;
}

// The equation of u_1 that is left: a body with one spring to a support, under a load.
//   M_11 (u_1)'' + M_12 (share u_1 + d)'' + k u_1 + k (u_1 - share u_1 - d) = load
SpringChain reducedChain(const SpringChain& whole) {
    SpringChain chain({[](double) { return 0.0; }, std::nullopt});
    chain.stiffness = (2 - share) * whole.stiffness;
    chain.mass = whole.mass + share * whole.sharedMass;
    chain.damping = whole.damping;
    chain.load = [&whole](double t) {
        const double d1 = 0.6 * t;
        const double d2 = 0.6;
        return whole.load(t) + whole.stiffness * offset(t) -
               whole.sharedMass * (d2 + whole.damping * d1);
    };
    return chain;
}

} // namespace

TEST(DependentUnknown, leaves_the_reduced_system) {
    for (const TimeScheme& scheme : {TimeScheme::quasiStatic(), TimeScheme::newmark(0.25, 0.5),
                                     TimeScheme::newmark(0.3, 0.6)}) {
        SpringChain whole = dependentChain();
        whole.sharedMass = scheme.dynamic ? 0.5 : 0;
        whole.damping = scheme.dynamic ? 0.8 : 0;
        SpringChain reduced = reducedChain(whole);
        TimeIntegrator integrator(whole, scheme, tight, 0);
        TimeIntegrator expected(reduced, scheme, tight, 0);
        advance(integrator, 15);
        advance(expected, 15);
        const double u1 = expected.state().displacement[1];
        const VectorXd& u = integrator.state().displacement;
        // Rounding of a few solutions; the motion's first acceleration is one of differences.
        EXPECT_NEAR(u[1], u1, 1e-9 * std::abs(u1));
        EXPECT_NEAR(u[2], share * u[1] + offset(15 * deltaT), 1e-14);
    }
}

TEST(DependentUnknown, is_solved_for_by_newtons_method_with_its_tangent) {
    SpringChain chain = dependentChain();
    chain.cubic = 300;
    TimeIntegrator integrator(chain, TimeScheme::quasiStatic(), tight, 0);
    integrator.beginTimeStep(1, 1);
    const VectorXd u = integrator.solve();
    const auto spring = [&](double e) { return chain.stiffness * e + chain.cubic * e * e * e; };
    EXPECT_NEAR(u[2], share * u[1] + offset(1), 1e-14);
    EXPECT_NEAR(spring(u[1]) - spring(u[2] - u[1]), chain.load(1), 1e-10);
    // Quadratic: the residual falls to less than 10 times its square in the last iterations.
    const std::vector<double>& residuals = integrator.residuals();
    ASSERT_GE(residuals.size(), 4U);
    const double last = residuals[residuals.size() - 2];
    EXPECT_LT(residuals.back(), std::max(10 * last * last, 1e-15));
}

TEST(DependentUnknown, is_moved_by_explicit_steps_as_by_implicit_ones) {
    SpringChain chain = dependentChain();
    EXPECT_LT(explicitMinusImplicit(chain), 1e-5);
}

TEST(DependentUnknown, limits_the_explicit_step_by_the_reduced_system) {
    SpringChain chain = dependentChain();
    ExplicitIntegrator integrator(chain, 0);
    const double omega = std::sqrt((2 - share) * chain.stiffness / chain.mass);
    // The estimate adds 1 % to the square of the frequency.
    EXPECT_NEAR(integrator.stableStep(VectorXd::Zero(3)), 2 / omega / std::sqrt(1.01), 1e-12);
}

TEST(DependentUnknown, vibrates_with_the_body_on_which_it_depends) {
    SpringChain chain(
        {[](double) { return 0.0; }, std::nullopt, offset, std::nullopt, std::nullopt});
    SparseMatrix dependence(5, 5);
    for (const int k : {1, 3, 4}) {
        dependence.insert(k, k) = 1;
    }
    dependence.insert(2, 1) = 1;
    chain.dependence = dependence;
    // Bodies 1 and 2 as one of twice the mass, in a row with 3 and 4.
    const Eigen::Matrix3d K =
        chain.stiffness * Eigen::Matrix3d{{2, -1, 0}, {-1, 2, -1}, {0, -1, 1}};
    const Eigen::Matrix3d M = chain.mass * Eigen::Vector3d(2, 1, 1).asDiagonal().toDenseMatrix();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> exact(K, M);
    const NaturalModes modes = naturalModes(chain, 2);
    for (int k = 0; k < 2; ++k) {
        const double square = std::pow(modes.angularFrequencies[k], 2);
        EXPECT_NEAR(square, exact.eigenvalues()[k], 1e-9 * square);
        EXPECT_NEAR(modes.shapes(2, k), modes.shapes(1, k), 1e-14);
    }
}
