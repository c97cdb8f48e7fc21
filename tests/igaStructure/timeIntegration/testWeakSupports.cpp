// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/timeIntegration/ArcLength.hpp"
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/SpringChain.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "igaStructure/timeIntegration/supportRates.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

// A weak support that moves is a spring to a support that moves: a chain that ends in one is
// the same as one with a body more, which is the support.

namespace {

using Motion = SpringChain::Motion;

const NewtonOptions tight{1e-13, 25, true};
constexpr double deltaT = 0.05;

double motion(double t) {
    return 0.1 * t * t * (3 - t);
}

/// Two bodies on a weak support.
SpringChain weaklySupported(double startTime = 0) {
    SpringChain chain({std::nullopt, std::nullopt});
    chain.anchor = chain.stiffness;
    chain.anchorMotion = [=](double t) { return motion(t - startTime); };
    chain.load = [=](double t) { return 0.7 * (t - startTime); };
    chain.damping = 0.4;
    return chain;
}

/// Two bodies on a spring to a support.
SpringChain supported() {
    SpringChain chain({motion, std::nullopt, std::nullopt});
    chain.load = [](double t) { return 0.7 * t; };
    chain.damping = 0.4;
    return chain;
}

double imbalance(const Energies& energies) {
    return energies.kinetic + energies.strain + energies.dampingWork - energies.externalWork;
}

TimeIntegrator advanced(SpringChain& chain, const TimeScheme& scheme, double startTime = 0) {
    TimeIntegrator integrator(chain, scheme, tight, startTime);
    for (int step = 1; step <= 20; ++step) {
        integrator.beginTimeStep(startTime + step * deltaT, deltaT);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    return integrator;
}

} // namespace

namespace {

const TimeScheme schemes[] = {TimeScheme::quasiStatic(), TimeScheme::newmark(0.25, 0.5),
                              TimeScheme::generalisedAlpha(0.5)};

} // namespace

TEST(WeakSupports, move_a_structure_as_a_spring_to_a_support) {
    for (const TimeScheme& scheme : schemes) {
        SpringChain weak = weaklySupported();
        SpringChain strong = supported();
        const VectorXd found = advanced(weak, scheme).state().displacement;
        const VectorXd expected = advanced(strong, scheme).state().displacement.tail(2);
        // Roundings of twenty solutions.
        EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
    }
}

TEST(WeakSupports, that_hardly_give_way_move_a_nonlinear_structure_as_a_support) {
    for (const TimeScheme& scheme : schemes) {
        SpringChain weak = weaklySupported();
        weak.cubic = 300;
        weak.anchor = 1e9;
        SpringChain strong({motion, std::nullopt});
        strong.cubic = weak.cubic;
        strong.load = weak.load;
        strong.damping = weak.damping;
        const VectorXd found = advanced(weak, scheme).state().displacement;
        const VectorXd expected = advanced(strong, scheme).state().displacement;
        // Of the stiffness of the chain's own spring, below 1e3, and of the inertia of a body.
        EXPECT_LT((found - expected).norm(), 1e3 / weak.anchor * expected.norm());
    }
}

TEST(WeakSupports, work_and_energies_are_those_of_a_spring_to_a_support) {
    SpringChain weak = weaklySupported();
    SpringChain strong = supported();
    const Energies found = advanced(weak, TimeScheme::newmark(0.25, 0.5)).energies();
    TimeIntegrator integrator = advanced(strong, TimeScheme::newmark(0.25, 0.5));
    const Energies expected = integrator.energies();
    EXPECT_NEAR(found.strain, expected.strain, 1e-9 * expected.strain);
    // Exact for the trapezoidal rule and a linear structure; the support that is a body has
    // kinetic energy and damping of its own.
    EXPECT_NEAR(imbalance(found), 0, 1e-11 * found.externalWork);
    EXPECT_NEAR(imbalance(expected), 0, 1e-9 * expected.externalWork);
    const double v = integrator.state().velocity[0];
    EXPECT_NEAR(expected.kinetic - found.kinetic, 0.5 * strong.mass * v * v,
                1e-9 * expected.kinetic);
}

TEST(WeakSupports, move_an_explicit_structure_with_the_same_energies) {
    SpringChain weak = weaklySupported();
    SpringChain strong = supported();
    ExplicitIntegrator found(weak, 0), expected(strong, 0);
    constexpr double step = 1e-3;
    for (int k = 1; k <= 1000; ++k) {
        found.advance(k * step, step);
        expected.advance(k * step, step);
    }
    EXPECT_LT((found.state().displacement - expected.state().displacement.tail(2)).norm(),
              1e-9 * expected.state().displacement.norm());
    EXPECT_NEAR(found.energies().strain, expected.energies().strain,
                1e-9 * expected.energies().strain);
    // Of second order, (w dt)^2 with w below 10 1/s; damping lags by half a part.
    EXPECT_NEAR(imbalance(found.energies()), 0, 1e-3 * found.energies().externalWork);
}

TEST(WeakSupports, lead_a_path_of_arc_length_and_do_its_work) {
    SpringChain weak = weaklySupported();
    weak.anchorMotion = [](double t) { return 0.2 * t; };
    ArcLength path(weak, tight, EquilibriumPath{100, 4}, 0.1, 1);
    double work = 0;
    while (path.state().time < 1) {
        path.advance();
        const double t = path.state().time;
        // Both loads pass through the weak support's spring, the second one through the other.
        const double first = 0.2 * t + 2 * 0.7 * t / weak.anchor;
        const double second = first + 0.7 * t / weak.stiffness;
        EXPECT_NEAR(path.state().displacement[0], first, 1e-11);
        EXPECT_NEAR(path.state().displacement[1], second, 1e-11);
        EXPECT_EQ(path.state().force[0], 0.7 * t);
        // All grows with t, so that forces do half of their work at the end: of loads, and of
        // the support on what it pulls.
        work = 0.5 * (0.7 * t * (first + second) - 2 * 0.7 * t * 0.2 * t);
        EXPECT_NEAR(path.energies().externalWork, work, 1e-11);
        EXPECT_NEAR(path.energies().strain, work, 1e-11);
    }
    ASSERT_GT(std::abs(work), 1e-3);
}

TEST(WeakSupports, that_are_displaced_at_the_start_are_refused_in_dynamics) {
    SpringChain chain = weaklySupported();
    chain.anchorMotion = [](double t) { return 1e-3 + t; };
    EXPECT_THROW(requireSupportsAtRest(chain, 0), InputError);
    chain.anchorMotion = [](double t) { return t; };
    EXPECT_NO_THROW(requireSupportsAtRest(chain, 0));
}

TEST(StartTime, shifts_loads_and_supports_and_changes_nothing_else) {
    constexpr double startTime = 2;
    SpringChain atZero = weaklySupported();
    SpringChain later = weaklySupported(startTime);
    const TimeScheme scheme = TimeScheme::generalisedAlpha(0.8);
    const TimeIntegrator expected = advanced(atZero, scheme);
    EXPECT_EQ(TimeIntegrator(later, scheme, tight, startTime).state().time, startTime);
    const TimeIntegrator found = advanced(later, scheme, startTime);
    // Differences of times from 2 on are rounded to 2e-16, of a step of 0.05.
    EXPECT_LT((found.state().displacement - expected.state().displacement).norm(),
              1e-11 * expected.state().displacement.norm());
    EXPECT_NEAR(found.energies().externalWork, expected.energies().externalWork,
                1e-11 * expected.energies().externalWork);
    ExplicitIntegrator explicitAtZero(atZero, 0), explicitLater(later, startTime);
    EXPECT_EQ(explicitLater.state().time, startTime);
    EXPECT_EQ(explicitLater.state().force.norm(), 0);
    for (int step = 1; step <= 20; ++step) {
        explicitAtZero.advance(step * deltaT, deltaT);
        explicitLater.advance(startTime + step * deltaT, deltaT);
    }
    EXPECT_LT((explicitLater.state().displacement - explicitAtZero.state().displacement).norm(),
              1e-11 * explicitAtZero.state().displacement.norm());
    EXPECT_NEAR(explicitLater.energies().externalWork, explicitAtZero.energies().externalWork,
                1e-11 * explicitAtZero.energies().externalWork);
}
