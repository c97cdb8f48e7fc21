// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/kinematics/shell/exampleShell.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::AllOf;
using testing::HasSubstr;

namespace {

NewtonOptions wholeUpdates() {
    NewtonOptions newton;
    newton.lineSearch = false;
    return newton;
}

// A step of a structure at rest under loads that bend it far: either it is in
// balance at the end, or the message says where and what to change.
void expectBalanceOrReason(StructuralModel& model, double step) {
    TimeIntegrator integrator(model, TimeScheme::generalisedAlpha(0.8), wholeUpdates(), 0);
    integrator.beginTimeStep(step, step);
    try {
        integrator.solve();
        EXPECT_TRUE(integrator.displacement().allFinite());
        EXPECT_LE(integrator.residuals().back(), NewtonOptions().tolerance);
    } catch (const SolverError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("time step"), HasSubstr("smaller time step")));
    }
}

// Position of the tip on the circle to which a moment of so many turns rolls a
// cantilever up.
Vector2d onCircle(double length, double turns) {
    const double kL = 2 * M_PI * turns;
    return {length * (std::sin(kL) / kL - 1), length * (1 - std::cos(kL)) / kL};
}

ShellDescription strip(double thickness, int degree, int nElements) {
    ShellDescription plate = onePatch(geometry::rectangle({0, 0, 0}, 12, 1), degree, nElements, 1,
                                      thickness, {1.2e6, 0, 100});
    plate.edgeSupports = {support(left, {true, true, true}, true)};
    return plate;
}

// 2 pi E I / L a turn, per width.
ScalarField rollingMoment(double thickness, double turns) {
    const double full = 2 * M_PI * 1.2e6 * std::pow(thickness, 3) / 12 / 12 * turns;
    return {[full](const geometry::Point&, double t) { return -full * t; }, true};
}

} // namespace

TEST(Extremes, time_step_a_thousand_times_too_large_ends_in_balance_or_with_a_reason) {
    // The first period of the beam is 2 pi / (3.516 sqrt(E I / m L^4)) = 57 s, a twentieth
    // of it a sound step.
    for (const double force : {0.01, 1.0, 100.0}) {
        ExampleBeam kind;
        kind.loads.ends.push_back(endForce("0", fmt::format("{}", force)));
        Beam line = kind.build();
        expectBalanceOrReason(line, 1e3 * 57 / 20);
        ShellDescription plate = strip(0.1, 4, 8);
        plate.loads.edgeForces = {{{0, right}, VectorField::constant({0, 0, force})}};
        Shell shell(std::move(plate));
        expectBalanceOrReason(shell, 1e3 * 82 / 20);
    }
}

TEST(Extremes, shell_rolls_up_twice_without_being_held_in_its_plane) {
    ShellDescription plate = strip(0.1, 4, 32);
    plate.loads.edgeMoments = {{{0, right}, rollingMoment(0.1, 2)}};
    Shell shell(std::move(plate));
    const VectorXd d = solveStatic(shell, 40, false);
    const Vector3d tip = shell.stateAt(0, 1, 0.5, d).displacement;
    // Its measure of curvature takes in a stretch of (t/R)^2/12, here 9e-4.
    EXPECT_LT((Vector2d(tip[0], tip[2]) - onCircle(12, 2)).norm(), 2e-3 * 12);
    EXPECT_LT(std::abs(tip[1]), 1e-6 * 12);
}

TEST(Extremes, beam_and_shell_of_thickness_1e_minus_5_roll_up_to_a_circle) {
    const double thickness = 12e-5; // degree 4 with 16 elements would lock
    BeamSection section;
    section.thickness = thickness;
    section.axialStiffness = 1.2e6 * thickness;
    section.bendingStiffness = 1.2e6 * std::pow(thickness, 3) / 12;
    section.mass = 1;
    BeamLoads loads;
    loads.ends.push_back(
        endMoment(fmt::format("{:.17g}*t", 2 * M_PI * section.bendingStiffness / 12)));
    Beam line(geometry::refine(geometry::line({0, 0, 0}, {12, 0, 0}), 5, 32), section,
              Strains::nonlinear, {{BeamEnd::start, true, true, true}}, loads);
    TimeIntegrator integrator(line, TimeScheme::quasiStatic(), wholeUpdates(), 0);
    for (int step = 1; step <= 20; ++step) {
        integrator.beginTimeStep(0.05 * step, 0.05);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    EXPECT_LT((endDisplacement(line, integrator.state().displacement) - onCircle(12, 1)).norm(),
              1e-3 * 12);
    ShellDescription plate = strip(thickness, 5, 32);
    plate.loads.edgeMoments = {{{0, right}, rollingMoment(thickness, 1)}};
    Shell shell(std::move(plate));
    const Vector3d tip = shell.stateAt(0, 1, 0.5, solveStatic(shell, 20, false)).displacement;
    EXPECT_LT((Vector2d(tip[0], tip[2]) - onCircle(12, 1)).norm(), 1e-3 * 12);
}

TEST(Extremes, beam_on_a_pin_is_spun_through_more_than_two_turns) {
    // A moment at its free end turns it as a rigid body, by M t^2 / 2 I.
    ExampleBeam kind;
    kind.degree = 3;
    kind.elements = 4;
    kind.supports = {{BeamEnd::start, true, true, false}};
    kind.loads.ends.push_back(endMoment("1"));
    Beam line = kind.build();
    TimeIntegrator integrator(line, TimeScheme::generalisedAlpha(0.8), wholeUpdates(), 0);
    double angle = 0;
    Vector2d before(10, 0);
    for (int step = 1; step <= 300; ++step) {
        integrator.beginTimeStep(step, 1);
        integrator.solve();
        integrator.acceptTimeStep();
        const Vector2d now =
            Vector2d(10, 0) + endDisplacement(line, integrator.state().displacement);
        angle += std::atan2(before[0] * now[1] - before[1] * now[0], before.dot(now));
        before = now;
    }
    const double inertia = kind.section().mass * 1000 / 3;
    const double expected = 0.5 * 300 * 300 / inertia;
    EXPECT_GT(expected, 4 * M_PI);
    // It bends by M L / E I = 0.1 at most, and swings.
    EXPECT_NEAR(angle, expected, 0.1);
}

TEST(Extremes, free_shell_under_a_dead_couple_turns_as_a_rigid_body) {
    // Forces at both ends keep their directions: the plate swings about them like a
    // pendulum, over half a turn each way, and keeps its energy.
    ShellDescription plate =
        onePatch(geometry::rectangle({-0.5, 0, 0}, 1, 0.2), 2, 4, 1, 0.05, {1e7, 0.3, 100});
    plate.loads.edgeForces = {{{0, right}, VectorField::constant({-0.5, 0, 0.5})},
                              {{0, left}, VectorField::constant({0.5, 0, -0.5})}};
    Shell shell(std::move(plate));
    TimeIntegrator integrator(shell, TimeScheme::generalisedAlpha(0.9), wholeUpdates(), 0);
    double largest = 0;
    for (int step = 1; step <= 200; ++step) {
        integrator.beginTimeStep(0.02 * step, 0.02);
        integrator.solve();
        integrator.acceptTimeStep();
        const VectorXd& d = integrator.state().displacement;
        const Vector3d axis = Vector3d(1, 0, 0) + shell.stateAt(0, 1, 0.5, d).displacement -
                              shell.stateAt(0, 0, 0.5, d).displacement;
        EXPECT_NEAR(axis.norm(), 1, 0.02) << step; // it is stiff
        largest = std::max(largest, std::abs(std::atan2(axis[2], axis[0])));
    }
    EXPECT_GT(largest, M_PI / 2);
}
