// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/kinematics/solid/exampleSolid.hpp"
#include "igaStructure/timeIntegration/SpringChain.hpp"
#include "igaStructure/timeIntegration/Springs.hpp"

#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

namespace {

NewtonOptions reusing(double contraction) {
    NewtonOptions newton;
    newton.reuseContraction = contraction;
    return newton;
}

// Forced vibration of a solid, each step solved for several forces as in a coupled run.
struct Vibration {
    VectorXd end;
    int nFactorisations;
    int nIterations = 0;
};

Vibration vibrate(const NewtonOptions& newton, double amplitude) {
    PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::nonlinear, false});
    TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(0.8), newton, 0);
    Vibration vibration{{}, -integrator.nFactorisations()};
    VectorXd force = VectorXd::Zero(solid.nUnknowns());
    for (int step = 1; step <= 20; ++step) {
        integrator.beginTimeStep(0.01 * step, 0.01);
        for (const double share : {0.8, 1.1, 1.0}) {
            force[solid.nUnknowns() - 2] = share * amplitude * std::sin(10 * 0.01 * step);
            integrator.solve(force);
            vibration.nIterations += integrator.nIterations();
        }
        integrator.acceptTimeStep();
    }
    vibration.end = integrator.state().displacement;
    vibration.nFactorisations += integrator.nFactorisations();
    return vibration;
}

} // namespace

TEST(TangentReuse, solution_is_the_same_with_fewer_factorisations) {
    const Vibration expected = vibrate(reusing(0), 300);
    EXPECT_EQ(expected.nFactorisations, expected.nIterations);
    for (const double contraction : {0.1, 0.5}) {
        const Vibration reused = vibrate(reusing(contraction), 300);
        // Newton's tolerance is 1e-8 of the forces.
        EXPECT_LT((reused.end - expected.end).norm(), 1e-6 * expected.end.norm());
        EXPECT_LT(reused.nFactorisations, expected.nFactorisations / 3) << contraction;
    }
}

TEST(TangentReuse, new_size_of_the_time_step_takes_a_new_tangent) {
    PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::nonlinear, false});
    TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(0.8), reusing(0.5), 0);
    VectorXd force = VectorXd::Zero(solid.nUnknowns());
    double time = 0;
    std::vector<int> counts;
    for (const double deltaT : {0.01, 0.01, 0.001, 0.0012}) {
        force[solid.nUnknowns() - 2] += 1e-3; // so little that one tangent would do for all
        integrator.beginTimeStep(time += deltaT, deltaT);
        integrator.solve(force);
        integrator.acceptTimeStep();
        counts.push_back(integrator.nFactorisations());
    }
    EXPECT_EQ(counts[1], counts[0]);
    EXPECT_EQ(counts[2], counts[1] + 1);
    // The tangent of the shorter step would converge, but by a third in each iteration.
    EXPECT_EQ(counts[3], counts[2] + 1);
    EXPECT_EQ(integrator.nIterations(), 1);
}

namespace {

// A step in which a tangent is factored far from where the next one ends.
void takeLargeStep(PlaneSolid& solid, TimeIntegrator& integrator) {
    integrator.beginTimeStep(0.02, 0.01);
    integrator.solve(VectorXd::Constant(solid.nUnknowns(), 50));
}

VectorXd afterSmallStep(PlaneSolid& solid, TimeIntegrator& integrator) {
    integrator.beginTimeStep(0.02, 0.01);
    return integrator.solve(VectorXd::Constant(solid.nUnknowns(), 0.02));
}

} // namespace

TEST(TangentReuse, rejected_and_restored_steps_leave_no_tangent) {
    PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::nonlinear, false});
    const auto started = [&] {
        TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(0.8), reusing(0.5), 0);
        integrator.beginTimeStep(0.01, 0.01);
        integrator.solve(VectorXd::Constant(solid.nUnknowns(), 0.01));
        integrator.acceptTimeStep();
        return integrator;
    };
    TimeIntegrator straight = started();
    straight.dropTangent();
    const VectorXd expected = afterSmallStep(solid, straight);
    TimeIntegrator rejected = started();
    takeLargeStep(solid, rejected);
    rejected.rejectTimeStep();
    EXPECT_EQ(rejected.displacement(), rejected.state().displacement);
    EXPECT_EQ(afterSmallStep(solid, rejected), expected); // to the last bit
    TimeIntegrator restored = started();
    const MotionState state = restored.state();
    takeLargeStep(solid, restored);
    restored.acceptTimeStep();
    restored.restore(state, {});
    EXPECT_EQ(afterSmallStep(solid, restored), expected);
}

TEST(TangentReuse, tangent_that_no_longer_serves_is_replaced) {
    // A beam between two hinges is soft at rest and stiff once it is stretched: the old
    // tangent would move it by far too much.
    ExampleBeam kind;
    kind.supports.push_back({BeamEnd::end, true, true, false});
    kind.loads.tractions.push_back({Formula("0", ""), Formula("t < 1.5 ? -0.001*t : -100", "")});
    Beam line = kind.build();
    NewtonOptions newton = reusing(0.5);
    newton.maxIterations = 60;
    TimeIntegrator integrator(line, TimeScheme::quasiStatic(), newton, 0);
    for (int step = 1; step <= 2; ++step) {
        integrator.beginTimeStep(step, 1);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    TimeIntegrator fresh(line, TimeScheme::quasiStatic(), NewtonOptions{1e-10, 60, true}, 0);
    fresh.beginTimeStep(2, 2);
    const VectorXd expected = fresh.solve();
    EXPECT_LT((integrator.state().displacement - expected).norm(), 1e-6 * expected.norm());
    EXPECT_GE(integrator.nFactorisations(), 3); // at rest, and for the stretched beam
}

TEST(TangentReuse, tangent_serves_while_each_iteration_contracts_as_asked_for) {
    // A tangent of twice the stiffness halves the residual in each iteration.
    const auto nFactorisations = [](double contraction) {
        Springs springs(
            1, [](double u) { return u; }, [](double) { return 1; });
        springs.factor = [](int) { return 2; };
        NewtonOptions newton = reusing(contraction);
        newton.lineSearch = false;
        newton.maxIterations = 50;
        TimeIntegrator integrator(springs, TimeScheme::quasiStatic(), newton, 0);
        integrator.beginTimeStep(1, 1);
        EXPECT_NEAR(integrator.solve(VectorXd::Ones(1))[0], 1, 1e-7);
        EXPECT_GT(integrator.nIterations(), 20);
        return integrator.nFactorisations();
    };
    EXPECT_EQ(nFactorisations(0.51), 1);
    EXPECT_GT(nFactorisations(0.49), 20);
}

TEST(TangentReuse, kept_tangent_never_makes_the_residual_rise) {
    // Stiff where it is loaded with 10 N, at 2: there the tangent at rest steps by far too much.
    Springs springs(
        1, [](double u) { return u + u * u * u; }, [](double u) { return 1 + 3 * u * u; });
    TimeIntegrator integrator(springs, TimeScheme::quasiStatic(), reusing(0.9), 0);
    integrator.beginTimeStep(1, 1);
    integrator.solve(VectorXd::Constant(1, 1e-3));
    integrator.startFrom(VectorXd::Constant(1, 2.2));
    EXPECT_NEAR(integrator.solve(VectorXd::Constant(1, 10))[0], 2, 1e-6);
    for (std::size_t k = 1; k < integrator.residuals().size(); ++k) {
        EXPECT_LT(integrator.residuals()[k], integrator.residuals()[k - 1]);
    }
}

TEST(TangentReuse, static_tangent_serves_in_steps_of_any_length) {
    Springs springs(
        1, [](double u) { return u; }, [](double) { return 1; });
    springs.linear = true;
    TimeIntegrator integrator(springs, TimeScheme::quasiStatic(), {}, 0);
    for (const double time : {1.0, 1.5, 3.0}) {
        integrator.beginTimeStep(time, time / 2);
        integrator.solve(VectorXd::Ones(1));
        integrator.acceptTimeStep();
    }
    EXPECT_EQ(integrator.nFactorisations(), 1);
}

TEST(TangentReuse, contraction_is_told_to_others_while_a_tangent_of_the_step_serves) {
    PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::nonlinear, false});
    TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(0.8), reusing(0.3), 0);
    integrator.beginTimeStep(0.01, 0.01);
    EXPECT_EQ(integrator.reuseContraction(), 0);
    integrator.linearise(integrator.displacement());
    EXPECT_EQ(integrator.reuseContraction(), 0.3);
    integrator.dropTangent();
    EXPECT_EQ(integrator.reuseContraction(), 0);
    integrator.solve(VectorXd::Constant(solid.nUnknowns(), 0.01));
    integrator.acceptTimeStep();
    integrator.beginTimeStep(0.03, 0.02); // of another length
    EXPECT_EQ(integrator.reuseContraction(), 0);
}

TEST(TangentReuse, linear_solution_is_the_same_to_the_last_bit_whatever_was_solved_before) {
    PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::linear, false});
    const VectorXd force = VectorXd::LinSpaced(solid.nUnknowns(), -1, 2);
    TimeIntegrator once(solid, TimeScheme::generalisedAlpha(0.8), {}, 0);
    TimeIntegrator often(solid, TimeScheme::generalisedAlpha(0.8), {}, 0);
    for (TimeIntegrator* integrator : {&once, &often}) {
        integrator->beginTimeStep(0.01, 0.01);
    }
    often.solve(-3 * force);
    EXPECT_EQ(often.solve(force), once.solve(force));
    EXPECT_EQ(often.nIterations(), 1);
}

TEST(TangentReuse, motion_of_supports_is_one_iteration_where_springs_are_linear) {
    // Newton's method, as the law is said to be nonlinear.
    SpringChain chain({std::nullopt, std::nullopt, [](double t) { return 3 * t; }});
    chain.cubic = 1e-30;
    chain.load = [](double t) { return 5 * t; };
    TimeIntegrator integrator(chain, TimeScheme::quasiStatic(), reusing(0), 0);
    for (int step = 1; step <= 3; ++step) {
        integrator.beginTimeStep(step, 1);
        integrator.solve();
        EXPECT_EQ(integrator.nIterations(), 1);
        integrator.acceptTimeStep();
    }
}

TEST(TangentReuse, memory_is_that_of_the_factors_and_three_matrices) {
    PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::linear, false});
    TimeIntegrator integrator(solid, TimeScheme::generalisedAlpha(0.8), {}, 0);
    const double entries = static_cast<double>(solid.massMatrix().nonZeros());
    EXPECT_GT(integrator.solver().bytes(), 0);
    EXPECT_EQ(integrator.bytes() - integrator.solver().bytes(),
              3 * entries * (sizeof(double) + sizeof(int)));
}
