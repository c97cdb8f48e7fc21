// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

namespace {

// A cantilever 0.1 x 1, clamped at the bottom.
struct Cantilever {
    Strains strains = Strains::linear;
    double poissonsRatio = 0;
    int elements = 4;
    std::string tractionX = "0"; ///< on the left edge
    std::string gravityX = "0";
    std::vector<Support> supports = {{geometry::Edge::bottom, {true, true}}};
    double massDamping = 0;
    double stiffnessDamping = 0;
    Kinematics kinematics = Kinematics::planeStress;

    PlaneSolid build() const {
        PlaneMaterial material;
        material.kinematics = kinematics;
        material.youngsModulus = 4e6;
        material.poissonsRatio = poissonsRatio;
        material.density = 3000;
        material.massDamping = massDamping;
        material.stiffnessDamping = stiffnessDamping;
        Loads loads;
        loads.tractions.push_back(
            {geometry::Edge::left, {Formula(tractionX, ""), Formula("0", "")}});
        loads.gravities.push_back({{Formula(gravityX, ""), Formula("0", "")}});
        return {geometry::refine(geometry::rectangle({-0.05, 0, 0}, 0.1, 1), 2, 3, 1, elements),
                material, strains, supports, loads};
    }
};

double tipX(const PlaneSolid& solid, const VectorXd& displacement) {
    return solid.stateAt(0.5, 1, displacement).displacement[0];
}

// Advances to a time, returns the tip's displacement.
double tipAt(double endTime, int nSteps, const Cantilever& cantilever, const TimeScheme& scheme) {
    PlaneSolid solid = cantilever.build();
    TimeIntegrator integrator(solid, scheme, NewtonOptions{1e-11, 25, true}, 0);
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(step * endTime / nSteps, endTime / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    return tipX(solid, integrator.state().displacement);
}

double staticTip(const Cantilever& cantilever, int loadSteps = 1) {
    return tipAt(1, loadSteps, cantilever, TimeScheme::quasiStatic());
}

} // namespace

TEST(TimeIntegrator, static_cantilever_bends_as_timoshenkos_beam) {
    Cantilever cantilever;
    cantilever.tractionX = "1000";
    // w = q l^4 / 8 E I + q l^2 / 2 k G A; Poisson's ratio 0, so k = 5/6, G = E/2.
    const double EI = 4e6 * std::pow(0.1, 3) / 12;
    const double kGA = 5.0 / 6 * 2e6 * 0.1;
    const double expected = 1000 / (8 * EI) + 1000 / (2 * kGA);
    // At the clamp the section cannot warp, which stiffens by a share of (h/l)^2 = 1e-2.
    EXPECT_NEAR(staticTip(cantilever), expected, 2e-3 * expected);
}

TEST(TimeIntegrator, slender_cantilever_rolls_up_as_the_elastica) {
    // Tip load P l^2 / E I = 1 across the original axis: Mattiasson 1981 gives
    // the deflections 0.30172 l and 0.05643 l.
    Cantilever cantilever;
    cantilever.strains = Strains::nonlinear;
    cantilever.elements = 12;
    PlaneSolid solid = cantilever.build();
    TimeIntegrator integrator(solid, TimeScheme::quasiStatic(), {}, 0);
    const double EI = 4e6 * std::pow(0.1, 3) / 12;
    VectorXd force = VectorXd::Zero(solid.nUnknowns());
    const geometry::BoundaryCurve top = solid.surface().boundaryCurve(geometry::Edge::top);
    for (std::size_t i = 0; i < top.controlPoints.size(); ++i) {
        force[2 * top.controlPoints[i]] = EI / top.controlPoints.size(); // sums to P
    }
    for (int step = 1; step <= 4; ++step) {
        integrator.beginTimeStep(0.25 * step, 0.25);
        integrator.solve(0.25 * step * force);
        integrator.acceptTimeStep();
    }
    const Eigen::Vector2d tip = solid.stateAt(0.5, 1, integrator.state().displacement).displacement;
    // Shear adds P l / k G A = 0.0020 l to the deflection; stretching is smaller.
    EXPECT_NEAR(tip[0], 0.30172 + 0.0020, 0.003 * 0.30172);
    EXPECT_NEAR(-tip[1], 0.05643, 0.015 * 0.05643);
}

TEST(TimeIntegrator, nonlinear_strains_agree_with_linear_ones_for_small_loads) {
    Cantilever cantilever;
    cantilever.tractionX = "0.01";
    const double linear = staticTip(cantilever);
    cantilever.strains = Strains::nonlinear;
    // The rotation is 4/3 of the tip's displacement over the length, here 5e-6; it gives
    // the load, which acts on the edge beside the axis, a lever of that order.
    EXPECT_NEAR(staticTip(cantilever), linear, 5e-6 * linear);
}

TEST(TimeIntegrator, newtons_method_converges_quadratically) {
    Cantilever cantilever;
    cantilever.strains = Strains::nonlinear;
    cantilever.tractionX = "1000";
    PlaneSolid solid = cantilever.build();
    TimeIntegrator integrator(solid, TimeScheme::quasiStatic(), {1e-12, 25, true}, 0);
    integrator.beginTimeStep(1, 1);
    integrator.solve();
    const std::vector<double>& residuals = integrator.residuals();
    ASSERT_GE(residuals.size(), 4u);
    // From where the residual is small each iteration squares it, up to a factor
    // that a linearly convergent iteration would need to be huge, and up to rounding.
    int nChecked = 0;
    for (std::size_t k = 0; k + 1 < residuals.size(); ++k) {
        if (residuals[k] < 1e-2 && residuals[k + 1] > 1e-13) {
            EXPECT_LT(residuals[k + 1], 100 * residuals[k] * residuals[k]);
            ++nChecked;
        }
    }
    EXPECT_GE(nChecked, 1);
}

TEST(TimeIntegrator, trapezoidal_rule_keeps_energy) {
    Cantilever cantilever;
    cantilever.tractionX = "t < 0.1 ? 1000 : 0"; // pushed, then free
    PlaneSolid solid = cantilever.build();
    TimeIntegrator integrator(solid, TimeScheme::newmark(0.25, 0.5), {}, 0);
    double afterPush = 0;
    for (int step = 1; step <= 300; ++step) {
        integrator.beginTimeStep(0.01 * step, 0.01);
        integrator.solve();
        integrator.acceptTimeStep();
        const Energies& energies = integrator.energies();
        const double total = energies.kinetic + energies.strain;
        if (step == 11) {
            afterPush = total;
            ASSERT_GT(afterPush, 0);
        }
        // Exact for a linear structure, up to the rounding of 300 solutions.
        EXPECT_NEAR(total, energies.externalWork, 1e-9 * std::abs(total)) << step;
        if (step > 11) {
            EXPECT_NEAR(total, afterPush, 1e-9 * afterPush) << step;
        }
    }
}

TEST(TimeIntegrator, trapezoidal_rule_keeps_energy_and_what_damping_takes) {
    Cantilever cantilever;
    cantilever.tractionX = "1000*sin(9*t)";
    cantilever.massDamping = 0.4;
    cantilever.stiffnessDamping = 0.04;
    PlaneSolid solid = cantilever.build();
    TimeIntegrator integrator(solid, TimeScheme::newmark(0.25, 0.5), {}, 0);
    double before = 0;
    for (int step = 1; step <= 100; ++step) {
        integrator.beginTimeStep(0.02 * step, 0.02);
        integrator.solve();
        integrator.acceptTimeStep();
        const Energies& energies = integrator.energies();
        EXPECT_GT(energies.dampingWork, before) << step;
        before = energies.dampingWork;
        // Exact for a linear structure, up to the rounding of 100 solutions.
        EXPECT_NEAR(energies.kinetic + energies.strain + energies.dampingWork,
                    energies.externalWork, 1e-9 * before)
            << step;
    }
}

namespace {

// Distance to the exact motion of the lowest mode after a time, over its amplitude, released
// from rest: q'' + (a + b w^2) q' + w^2 q = 0, a and b the damping of mass and stiffness.
double errorOfDampedMode(const TimeScheme& scheme, int nSteps) {
    Cantilever cantilever;
    cantilever.massDamping = 0.4;
    cantilever.stiffnessDamping = 0.04;
    PlaneSolid solid = cantilever.build();
    const NaturalModes modes = naturalModes(solid, 1);
    const double w = modes.angularFrequencies[0];
    const VectorXd shape = modes.shapes.col(0);
    TimeIntegrator integrator(solid, scheme, {}, 0);
    MotionState start = integrator.state();
    start.displacement = shape;
    start.acceleration = -w * w * shape;
    integrator.restore(start, {});
    const double endTime = 1.5; // most of a period
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(step * endTime / nSteps, endTime / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    const double decay = 0.5 * (cantilever.massDamping + cantilever.stiffnessDamping * w * w);
    const double dampedW = std::sqrt(w * w - decay * decay);
    const double phase = dampedW * endTime;
    const double exact =
        std::exp(-decay * endTime) * (std::cos(phase) + decay / dampedW * std::sin(phase));
    return (integrator.state().displacement - exact * shape).norm() / shape.norm();
}

} // namespace

TEST(TimeIntegrator, natural_mode_moves_as_a_damped_oscillator_with_an_error_of_second_order) {
    for (const TimeScheme& scheme :
         {TimeScheme::generalisedAlpha(0.8), TimeScheme::newmark(0.25, 0.5),
          TimeScheme::newmark(0.3, 0.5)}) {
        const double coarse = errorOfDampedMode(scheme, 100);
        const double fine = errorOfDampedMode(scheme, 200);
        EXPECT_LT(coarse, 2e-3); // (w dt)^2/12 (w t) = 1.4e-3 without damping, w = 3.7
        EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
    }
}

TEST(TimeIntegrator, spectral_radius_below_one_dissipates_and_one_does_not) {
    const auto remaining = [](double spectralRadius) {
        Cantilever cantilever;
        cantilever.gravityX = "t < 0.005 ? 1000 : 0"; // a blow: high frequencies too
        PlaneSolid solid = cantilever.build();
        TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(spectralRadius), {}, 0);
        double start = 0;
        for (int step = 1; step <= 200; ++step) {
            integrator.beginTimeStep(0.01 * step, 0.01);
            integrator.solve();
            integrator.acceptTimeStep();
            const Energies& energies = integrator.energies();
            if (step == 2) {
                start = energies.kinetic + energies.strain;
            }
        }
        return (integrator.energies().kinetic + integrator.energies().strain) / start;
    };
    const double half = remaining(0.5);
    const double most = remaining(0.9);
    EXPECT_GT(half, 0.1); // the lowest frequency stays
    EXPECT_LT(half, most);
    EXPECT_LT(most, 1);
    EXPECT_NEAR(remaining(1), 1, 1e-9); // exact, up to the rounding of 200 solutions
}

class Order : public testing::TestWithParam<Strains> {};
INSTANTIATE_TEST_SUITE_P(Strains, Order, testing::Values(Strains::linear, Strains::nonlinear));

TEST_P(Order, error_falls_with_the_square_of_the_time_step) {
    Cantilever cantilever;
    cantilever.strains = GetParam();
    cantilever.elements = 2;
    cantilever.tractionX = "1000*sin(4*t)^2";
    for (const TimeScheme& scheme :
         {TimeScheme::generalisedAlpha(0.8), TimeScheme::newmark(0.25, 0.5)}) {
        const double coarse = tipAt(0.5, 400, cantilever, scheme);
        const double middle = tipAt(0.5, 800, cantilever, scheme);
        const double fine = tipAt(0.5, 1600, cantilever, scheme);
        // High modes seem to converge faster until the steps resolve them; another order
        // would be off by one.
        EXPECT_NEAR(std::log2(std::abs((coarse - middle) / (middle - fine))), 2, 0.1);
    }
}

TEST(TimeIntegrator, free_body_falls_as_a_parabola) {
    Cantilever cantilever;
    cantilever.supports = {};
    cantilever.gravityX = "-9.81";
    // Constant acceleration is exact for every scheme of the family.
    for (double radius : {0.0, 0.8, 1.0}) {
        EXPECT_NEAR(tipAt(2, 40, cantilever, TimeScheme::generalisedAlpha(radius)), -2 * 9.81,
                    1e-8);
    }
}

TEST(TimeIntegrator, mass_damping_slows_a_free_body_exponentially) {
    Cantilever cantilever;
    cantilever.supports = {};
    cantilever.gravityX = "-1";
    cantilever.massDamping = 3;
    // v' = -g - c v: x = -g/c (t - (1 - exp(-c t))/c); the scheme is of order 2.
    const double expected = -1.0 / 3 * (1 - (1 - std::exp(-3.0)) / 3);
    EXPECT_NEAR(tipAt(1, 1000, cantilever, TimeScheme::generalisedAlpha(0.8)), expected,
                1e-5 * std::abs(expected));
}

TEST(TimeIntegrator, repeated_solutions_of_a_step_depend_on_the_last_force_only) {
    for (Strains strains : {Strains::linear, Strains::nonlinear}) {
        Cantilever cantilever;
        cantilever.strains = strains;
        PlaneSolid solid = cantilever.build();
        const NewtonOptions tight{1e-12, 25, true};
        TimeIntegrator once(solid, TimeScheme::generalisedAlpha(0.8), tight, 0);
        TimeIntegrator often(solid, TimeScheme::generalisedAlpha(0.8), tight, 0);
        VectorXd force = VectorXd::Zero(solid.nUnknowns());
        force[solid.nUnknowns() - 2] = 20;
        for (int step = 1; step <= 5; ++step) {
            once.beginTimeStep(0.01 * step, 0.01);
            often.beginTimeStep(0.01 * step, 0.01);
            often.solve(3 * force);
            often.rejectTimeStep();
            often.beginTimeStep(0.01 * step, 0.01);
            often.solve(-2 * force);
            often.solve(force);
            once.solve(force);
            once.acceptTimeStep();
            often.acceptTimeStep();
            const double size = once.state().displacement.norm();
            EXPECT_LT((once.state().displacement - often.state().displacement).norm(), 1e-9 * size);
        }
    }
}

TEST(TimeIntegrator, linear_structure_is_factored_once_for_each_time_step_size) {
    Cantilever cantilever;
    PlaneSolid solid = cantilever.build();
    TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(0.8), {}, 0);
    const int atStart = integrator.nFactorisations();
    double time = 0;
    for (double deltaT : {0.01, 0.01, 0.01 * (1 + 1e-15), 0.02, 0.02}) {
        time += deltaT;
        integrator.beginTimeStep(time, deltaT);
        integrator.solve();
        integrator.solve();
        integrator.acceptTimeStep();
    }
    EXPECT_EQ(integrator.nFactorisations() - atStart, 2);
}

namespace {

std::string failure(const Cantilever& cantilever, int loadSteps) {
    try {
        staticTip(cantilever, loadSteps);
    } catch (const SolverError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(TimeIntegrator, missing_supports_of_a_static_analysis_are_named) {
    Cantilever cantilever;
    cantilever.supports = {};
    EXPECT_EQ(failure(cantilever, 1),
              "a static analysis needs supports against every rigid motion; nothing prevents: "
              "translation along x, translation along y, rotation about z; add supports");
    cantilever.supports = {{geometry::Edge::bottom, {false, true}}};
    EXPECT_NE(failure(cantilever, 1).find("prevents: translation along x; add"), std::string::npos);
    cantilever.supports = {{geometry::Edge::left, {true, false}}};
    EXPECT_NE(failure(cantilever, 1).find("prevents: translation along y; add"), std::string::npos);
}

TEST(TimeIntegrator, failed_newton_iteration_names_the_time) {
    Cantilever cantilever;
    cantilever.strains = Strains::nonlinear;
    cantilever.tractionX = "1e9"; // absurd
    const std::string message = failure(cantilever, 1);
    EXPECT_NE(message.find("time 1 s"), std::string::npos) << message;
    EXPECT_NE(message, "no error");
}

TEST(TimeIntegrator, column_that_is_pressed_beyond_its_buckling_load_is_refused) {
    Cantilever cantilever;
    cantilever.strains = Strains::nonlinear;
    PlaneSolid solid = cantilever.build();
    TimeIntegrator integrator(solid, TimeScheme::quasiStatic(), {}, 0);
    const double EI = 4e6 * std::pow(0.1, 3) / 12;
    const double criticalForce = M_PI * M_PI * EI / 4; // Euler, clamped and free, length 1
    const geometry::BoundaryCurve top = solid.surface().boundaryCurve(geometry::Edge::top);
    VectorXd force = VectorXd::Zero(solid.nUnknowns());
    // Loads of the quadratic basis that are uniform over the edge of one element.
    for (int k : top.controlPoints) {
        force[2 * k + 1] = -criticalForce / 3;
    }
    integrator.beginTimeStep(1, 1);
    EXPECT_NO_THROW(integrator.solve(0.9 * force));
    try {
        integrator.solve(1.1 * force);
        FAIL();
    } catch (const SolverError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("not positive definite"), std::string::npos) << message;
        EXPECT_NE(message.find("buckles"), std::string::npos) << message;
    }
}

TEST(TimeIntegrator, supports_hold_the_prestress_from_the_start) {
    ExampleBeam kind;
    BeamSection section = kind.section();
    section.bendingStiffness = 0;
    section.prestress = 50;
    Beam cable(kind.curve(), section, Strains::nonlinear,
               {{BeamEnd::start, true, true}, {BeamEnd::end, true, true}}, {});
    // Along the cable, away from it at both ends
    VectorXd expected = VectorXd::Zero(cable.nUnknowns());
    expected[0] = -section.prestress;
    expected[cable.nUnknowns() - 2] = section.prestress;
    for (const TimeScheme& scheme :
         {TimeScheme::quasiStatic(), TimeScheme::generalisedAlpha(0.5)}) {
        TimeIntegrator integrator(cable, scheme, {}, 0);
        // Integrals of derivatives of the basis by a rule of a few points: rounding.
        EXPECT_LT((integrator.state().reaction - expected).norm(), 1e-12 * section.prestress);
        integrator.beginTimeStep(0.1, 0.1);
        integrator.solve();
        EXPECT_LT((integrator.reaction() - expected).norm(), 1e-9 * section.prestress);
    }
}

TEST(TimeIntegrator, force_that_is_not_finite_is_refused) {
    PlaneSolid solid = Cantilever{}.build();
    TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(0.8), {}, 0);
    integrator.beginTimeStep(0.01, 0.01);
    EXPECT_THROW(integrator.solve(VectorXd::Constant(solid.nUnknowns(), NAN)), SolverError);
}

namespace {

// A straight beam without supports under a pressure that grows with time: it moves across
// its axis as one mass.
Beam freeBeamUnderPressure(bool follows) {
    ExampleBeam kind;
    kind.supports = {};
    if (follows) {
        kind.loads.pressures.push_back(Formula("3*t", ""));
    } else {
        kind.loads.tractions.push_back({Formula("0", ""), Formula("-3*t", "")});
    }
    return kind.build();
}

MotionState freeMotion(Beam& beam, const TimeScheme& scheme, Energies& energies) {
    TimeIntegrator integrator(beam, scheme, NewtonOptions{1e-12, 25, true}, 0);
    for (int step = 1; step <= 10; ++step) {
        integrator.beginTimeStep(0.1 * step, 0.1);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    energies = integrator.energies();
    return integrator.state();
}

} // namespace

TEST(TimeIntegrator, follower_loads_are_those_of_the_time_of_the_balance) {
    for (const double radius : {0.0, 0.5, 0.9}) {
        const TimeScheme scheme = TimeScheme::generalisedAlpha(radius);
        Beam follower = freeBeamUnderPressure(true);
        Beam dead = freeBeamUnderPressure(false);
        Energies ofFollower;
        Energies ofDead;
        const MotionState motion = freeMotion(follower, scheme, ofFollower);
        const MotionState expected = freeMotion(dead, scheme, ofDead);
        ASSERT_GT(expected.displacement.norm(), 0);
        // A load that is linear in time has its mean at that time: both are the same.
        EXPECT_LT((motion.displacement - expected.displacement).norm(),
                  1e-9 * expected.displacement.norm());
        EXPECT_NEAR(ofFollower.externalWork, ofDead.externalWork, 1e-9 * ofDead.externalWork);
    }
}

TEST(TimeIntegrator, work_of_follower_loads_is_the_kinetic_energy_of_a_free_beam) {
    Beam beam = freeBeamUnderPressure(true);
    Energies energies;
    freeMotion(beam, TimeScheme::newmark(0.25, 0.5), energies);
    // Exact for the trapezoidal rule: both are products of means and differences.
    ASSERT_GT(energies.kinetic, 0);
    EXPECT_NEAR(energies.externalWork, energies.kinetic, 1e-9 * energies.kinetic);
}

TEST(TimeIntegrator, work_of_follower_loads_goes_on_from_a_saved_state) {
    Beam beam = freeBeamUnderPressure(true);
    Energies energies;
    const TimeScheme scheme = TimeScheme::newmark(0.25, 0.5);
    const MotionState saved = freeMotion(beam, scheme, energies);
    TimeIntegrator later(beam, scheme, NewtonOptions{1e-12, 25, true}, 0);
    later.restore(saved, energies);
    later.beginTimeStep(1.1, 0.1);
    later.solve();
    later.acceptTimeStep();
    // As without an end in between
    EXPECT_NEAR(later.energies().externalWork, later.energies().kinetic,
                1e-9 * later.energies().kinetic);
}

class StepsEquations : public testing::TestWithParam<std::pair<Strains, bool>> {
  protected:
    static constexpr double deltaT = 0.02;

    // In a step from a state in motion, with loads of its own.
    StepsEquations() : solid_(cantilever().build()), integrator_(solid_, scheme(), newton(), 0) {
        for (int step = 1; step <= 3; ++step) {
            integrator_.beginTimeStep(step * deltaT, deltaT);
            integrator_.solve(0.1 * step * force_());
            integrator_.acceptTimeStep();
        }
        integrator_.beginTimeStep(4 * deltaT, deltaT);
    }
    static Cantilever cantilever() {
        Cantilever cantilever;
        cantilever.strains = GetParam().first;
        cantilever.tractionX = "1000*t";
        cantilever.massDamping = 0.4;
        cantilever.stiffnessDamping = 0.01;
        return cantilever;
    }
    static TimeScheme scheme() {
        return GetParam().second ? TimeScheme::generalisedAlpha(0.5) : TimeScheme::quasiStatic();
    }
    static NewtonOptions newton() { return {1e-13, 25, true}; }
    VectorXd force_() const {
        VectorXd force = VectorXd::LinSpaced(solid_.nUnknowns(), -30, 30);
        setFixedToZero(solid_.fixed(), force);
        return force;
    }

    PlaneSolid solid_;
    TimeIntegrator integrator_;
};

INSTANTIATE_TEST_SUITE_P(Kinds, StepsEquations,
                         testing::Values(std::pair{Strains::linear, false},
                                         std::pair{Strains::nonlinear, false},
                                         std::pair{Strains::linear, true},
                                         std::pair{Strains::nonlinear, true}));

TEST_P(StepsEquations, required_force_is_the_one_that_solves) {
    const VectorXd displacement = integrator_.solve(force_());
    const VectorXd required = integrator_.requiredForce(displacement);
    EXPECT_LT((required - force_()).norm(), 1e-8 * force_().norm()); // Newton's tolerance
    for (int k = 0; k < solid_.nUnknowns(); ++k) {
        if (solid_.fixed()[k]) {
            EXPECT_EQ(required[k], 0);
        }
    }
}

TEST_P(StepsEquations, responses_are_derivatives_of_the_solution) {
    Eigen::MatrixXd directions(solid_.nUnknowns(), 2);
    directions << VectorXd::Ones(solid_.nUnknowns()), force_();
    const double h = 1e-3;
    Eigen::MatrixXd differences(solid_.nUnknowns(), 2);
    for (int k = 0; k < 2; ++k) {
        const VectorXd plus = integrator_.solve(force_() + h * directions.col(k));
        differences.col(k) = (plus - integrator_.solve(force_() - h * directions.col(k))) / (2 * h);
    }
    integrator_.linearise(VectorXd(integrator_.solve(force_())));
    const Eigen::MatrixXd responses = integrator_.responses(directions);
    // Differences of solutions to 1e-13: a few digits less than that over h.
    EXPECT_LT((responses - differences).norm(), 1e-5 * differences.norm());
}
