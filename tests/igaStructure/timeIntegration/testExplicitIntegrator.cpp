// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/kinematics/beam/exampleBeamCase.hpp"
#include "igaStructure/kinematics/solid/exampleSolid.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/SpringChain.hpp"
#include "temporaryDirectory.hpp"

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

ExampleBeam loadedBeam(Strains strains) {
    ExampleBeam kind;
    kind.strains = strains;
    kind.degree = 3;
    kind.elements = 6;
    kind.loads.ends.push_back(endForce("0", "2"));
    return kind;
}

} // namespace

TEST(ExplicitIntegrator, stable_step_is_that_of_the_highest_frequency) {
    Beam line = loadedBeam(Strains::linear).build();
    ExplicitIntegrator integrator(line, 0);
    SparseMatrix tangent;
    line.internalForce(VectorXd::Zero(line.nUnknowns()), tangent);
    std::vector<int> free;
    for (int k = 0; k < line.nUnknowns(); ++k) {
        if (!line.fixed()[k]) {
            free.push_back(k);
        }
    }
    const MatrixXd K = MatrixXd(tangent)(free, free);
    const MatrixXd M = MatrixXd(line.lumpedMassMatrix())(free, free);
    const double highest = Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(K, M)
                               .eigenvalues()
                               .cwiseSqrt()
                               .maxCoeff();
    const double exact = 2 / highest;
    const double estimate = integrator.stableStep(VectorXd::Zero(line.nUnknowns()));
    EXPECT_NEAR(estimate, exact, 0.02 * exact); // 0.5 % below by choice, power iteration 1 %
}

TEST(ExplicitIntegrator, lumped_mass_is_the_mass_of_the_body) {
    const PlaneSolid solid = makeExample({Kinematics::planeStress, Strains::linear, false});
    const SparseMatrix mass = solid.lumpedMassMatrix();
    EXPECT_NEAR(mass.sum(), 2 * 3000 * 0.1 * 0.2, 1e-9);
    EXPECT_GT(VectorXd(mass.diagonal()).minCoeff(), 0);
    ExampleBeam free;
    free.supports = {};
    EXPECT_NEAR(free.build().lumpedMassMatrix().sum(), 2 * 10 * 10, 1e-9);
}

TEST(ExplicitIntegrator, nonlinear_beam_moves_as_with_the_implicit_scheme) {
    ExampleBeam kind = loadedBeam(Strains::nonlinear);
    kind.elements = 16;
    Beam line = kind.build();
    ExplicitIntegrator integrator(line, 0);
    TimeIntegrator implicit(line, TimeScheme::newmark(0.25, 0.5), NewtonOptions{1e-10, 25, true},
                            0);
    const double step = 0.05;
    for (int k = 1; k <= 100; ++k) {
        integrator.advance(k * step, step);
        implicit.beginTimeStep(k * step, step);
        implicit.solve();
        implicit.acceptTimeStep();
    }
    const double tip = endDisplacement(line, implicit.state().displacement)[1];
    EXPECT_GT(std::abs(tip), 1); // a tenth of the length
    // The lumped mass changes the lower modes by an error of h^2.
    EXPECT_NEAR(endDisplacement(line, integrator.state().displacement)[1], tip,
                0.02 * std::abs(tip));
    const Energies& energies = integrator.energies();
    EXPECT_NEAR(energies.kinetic + energies.strain, energies.externalWork,
                0.01 * energies.externalWork);
}

TEST(ExplicitIntegrator, mass_damping_slows_a_free_body_by_its_rate_half_a_part_late) {
    PlaneMaterial material = exampleMaterial(Kinematics::planeStrain);
    material.massDamping = 3;
    Loads loads;
    loads.gravities.push_back({{Formula("-1", ""), Formula("0", "")}});
    PlaneSolid solid(geometry::refine(geometry::rectangle({0, 0, 0}, 0.1, 1), 2, 3, 1, 4), material,
                     Strains::linear, {}, loads);
    ExplicitIntegrator integrator(solid, 0);
    const int nParts = integrator.advance(1, 1).nIterations;
    // v' = -1 - 3 v; at the middle of the part before, the velocity is that of half a part
    // ago, which changes the rate to 3 (1 + 3 dt / 2).
    const double lag = 3 * 0.5 / nParts;
    const double rate = 3 * (1 + lag);
    const double expected = -(1 - (1 - std::exp(-rate)) / rate) / 3;
    EXPECT_NEAR(integrator.state().displacement[0], expected, 0.1 * lag * std::abs(expected));
    const Energies& energies = integrator.energies();
    // Work of the middle velocities: exact but for the lag.
    EXPECT_NEAR(energies.kinetic + energies.dampingWork, energies.externalWork,
                3 * lag * energies.externalWork);
    EXPECT_GT(energies.dampingWork, energies.kinetic);
}

TEST(ExplicitIntegrator, stiffness_damping_is_refused) {
    PlaneMaterial material = exampleMaterial(Kinematics::planeStrain);
    material.stiffnessDamping = 0.1;
    PlaneSolid solid(geometry::refine(geometry::rectangle({0, 0, 0}, 0.1, 1), 2, 3, 1, 4), material,
                     Strains::linear, {{geometry::Edge::bottom, {true, true}}}, {});
    EXPECT_THROW(ExplicitIntegrator(solid, 0), InputError);
}

TEST(ExplicitIntegrator, flap_runs_from_its_case_file) {
    const TemporaryDirectory directory;
    runAlone(readCase(directory.write("case.yaml",
                                      exampleText("time:\n", "time:\n  scheme: explicit\n"))),
             [](const std::string&) {});
    const auto explicitRows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    runAlone(readCase(directory.write("case.yaml", exampleText())), [](const std::string&) {});
    const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    // The implicit run has 10 steps only, the lumped mass its own error.
    EXPECT_NEAR(explicitRows.back()[1], rows.back()[1], 0.05 * rows.back()[1]);
}

namespace {

/// A motion that is known within a run only.
SpringChain::Motion within(double end, const SpringChain::Motion& motion) {
    return [=](double t) { return t < -1e-12 || t > end + 1e-12 ? NAN : motion(t); };
}

} // namespace

TEST(ExplicitIntegrator, work_of_supports_is_the_kinetic_energy_of_what_only_they_move) {
    // Two supports on the same parabola, of constant forces, and a body that they do not
    // move: all is exact.
    const auto motion = within(0.4, [](double t) { return 0.5 * 3 * t * t; });
    SpringChain chain({motion, motion, std::nullopt});
    chain.stiffness = 1e-13;
    ExplicitIntegrator integrator(chain, 0);
    for (int step = 1; step <= 4; ++step) {
        const double time = 0.1 * step;
        integrator.advance(time, 0.1);
        const Energies energies = integrator.energies();
        EXPECT_NEAR(energies.kinetic, 0.5 * 2 * chain.mass * std::pow(3 * time, 2), 1e-12);
        EXPECT_NEAR(energies.externalWork, energies.kinetic, 1e-12);
        EXPECT_NEAR(integrator.state().reaction[1], chain.mass * 3, 1e-11);
        EXPECT_NEAR(integrator.state().acceleration[1], 3, 1e-11);
    }
}

TEST(ExplicitIntegrator, supports_that_start_with_a_velocity_give_it_to_themselves_alone) {
    // m u'' + k (u - v t) = 0 from rest: u = v t - v/w sin(w t).
    constexpr double v = 0.3;
    constexpr double end = 1;
    SpringChain chain({std::nullopt, within(end, [](double t) { return v * t; })});
    ExplicitIntegrator integrator(chain, 0);
    constexpr int nSteps = 1000;
    for (int step = 1; step <= nSteps; ++step) {
        integrator.advance(step * end / nSteps, end / nSteps);
    }
    const double w = std::sqrt(chain.stiffness / chain.mass);
    const double expected = v * end - v / w * std::sin(w * end);
    // Of second order: (w dt)^2 / 24 (w t), w = 4.5
    EXPECT_NEAR(integrator.state().displacement[0], expected, 1e-5 * expected);
    EXPECT_NEAR(integrator.state().velocity[1], v, 1e-12);
    const Energies energies = integrator.energies();
    EXPECT_NEAR(energies.externalWork, energies.kinetic + energies.strain,
                1e-4 * energies.externalWork);
}

TEST(ExplicitIntegrator, velocity_at_the_start_is_the_impact_on_the_supports_own_mass) {
    const auto motion = within(1e-3, [](double t) { return 0.3 * t; });
    SpringChain chain({motion, motion, std::nullopt});
    ExplicitIntegrator integrator(chain, 0);
    integrator.advance(1e-3, 1e-3);
    // The spring to the third body is stretched by 3e-4: work of 2e-6.
    EXPECT_NEAR(integrator.energies().externalWork, 0.5 * 2 * chain.mass * 0.09, 1e-5);
}

TEST(ExplicitIntegrator, follower_loads_move_a_free_straight_beam_as_dead_ones) {
    const auto end = [](bool follows) {
        ExampleBeam kind;
        kind.supports = {};
        if (follows) {
            kind.loads.pressures.push_back(Formula("3*t", ""));
        } else {
            kind.loads.tractions.push_back({Formula("0", ""), Formula("-3*t", "")});
        }
        Beam beam = kind.build();
        ExplicitIntegrator integrator(beam, 0);
        for (int step = 1; step <= 4; ++step) {
            integrator.advance(0.05 * step, 0.05);
        }
        return std::pair(integrator.state().displacement, integrator.energies().externalWork);
    };
    const auto [found, work] = end(true);
    const auto [expected, expectedWork] = end(false);
    ASSERT_GT(expected.norm(), 0);
    EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
    EXPECT_NEAR(work, expectedWork, 1e-9 * expectedWork);
}

TEST(ExplicitIntegrator, steps_take_as_many_parts_as_nine_tenths_of_the_stable_step_fit_in) {
    SpringChain chain({std::nullopt, [](double) { return 0.0; }});
    chain.load = [](double t) { return 2 * t; };
    ExplicitIntegrator integrator(chain, 0);
    const double part = 0.9 * integrator.stableStep(VectorXd::Zero(2));
    double time = 0;
    for (int step = 0; step < 30; ++step) { // whole parts, but for the rounding of times
        time += 3 * part;
        EXPECT_EQ(integrator.advance(time, 3 * part).nIterations, 3) << step;
        EXPECT_EQ(integrator.state().time, time);
        EXPECT_EQ(integrator.state().force[0], 2 * time);
    }
    EXPECT_EQ(integrator.advance(time + 3.01 * part, 3.01 * part).nIterations, 4);
}

TEST(ExplicitIntegrator, steps_of_many_parts_end_at_the_time_that_is_given) {
    SpringChain chain({std::nullopt, [](double) { return 0.0; }});
    chain.stiffness = 4e5;
    chain.load = [](double t) { return t; };
    ExplicitIntegrator integrator(chain, 0);
    for (int step = 1; step <= 40; ++step) {
        EXPECT_GT(integrator.advance(0.1 * step, 0.1).nIterations, 20);
        EXPECT_EQ(integrator.state().time, 0.1 * step);
    }
}

TEST(ExplicitIntegrator, stable_step_of_a_long_chain_is_found_from_below_within_a_percent) {
    // Between walls, n bodies: w = 2 sqrt(k/m) cos(pi / 2 (n + 1)); the next frequency is 2 %
    // below it.
    constexpr int n = 12;
    std::vector<std::optional<SpringChain::Motion>> motions(n + 2);
    motions.front() = motions.back() = [](double) { return 0.0; };
    SpringChain chain(motions);
    ExplicitIntegrator integrator(chain, 0);
    const double w = 2 * std::sqrt(chain.stiffness / chain.mass) * std::cos(0.5 * M_PI / (n + 1));
    const double estimate = integrator.stableStep(VectorXd::Zero(n + 2));
    EXPECT_LT(estimate, 2 / w);
    EXPECT_GT(estimate, 0.99 * 2 / w); // 0.5 % below by choice
}

TEST(ExplicitIntegrator, parts_follow_a_structure_that_stiffens) {
    SpringChain chain(
        {[](double) { return 0.0; }, std::nullopt, [](double t) { return 2 * t * t; }});
    chain.cubic = 300;
    ExplicitIntegrator integrator(chain, 0);
    EXPECT_EQ(integrator.advance(0.1, 0.1).nIterations, 1);
    for (int step = 2; step <= 9; ++step) {
        integrator.advance(0.1 * step, 0.1);
    }
    // Each spring stretched by 0.81 has 630 N/m in place of 40: w = 25 1/s at least.
    EXPECT_GE(integrator.advance(1, 0.1).nIterations, 2);
}

TEST(ExplicitIntegrator, motion_that_grows_beyond_all_bounds_is_refused) {
    SpringChain chain({[](double) { return 0.0; }, std::nullopt});
    chain.cubic = -1e3; // pulls away from 0.2 on
    chain.load = [](double t) { return 1e6 * t; };
    ExplicitIntegrator integrator(chain, 0);
    EXPECT_THAT(
        [&] { integrator.advance(20, 20); },
        testing::ThrowsMessage<SolverError>(testing::HasSubstr("the motion is not finite")));
}

TEST(ExplicitIntegrator, step_of_more_parts_than_can_be_counted_is_refused) {
    SpringChain chain({std::nullopt, [](double) { return 0.0; }});
    chain.stiffness = 1e30;
    ExplicitIntegrator integrator(chain, 0);
    EXPECT_THAT([&] { integrator.advance(1, 1); },
                testing::ThrowsMessage<SolverError>(
                    testing::AllOf(testing::HasSubstr("time 1 s"), testing::HasSubstr("parts"))));
}
