// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleShell.hpp"
#include "igaStructure/kinematics/shell/element/MembraneSection.hpp"
#include "igaStructure/kinematics/shell/element/NeoHookeanSection.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double incompressible = std::numeric_limits<double>::infinity();
const FundamentalForms skewed{{1.3, 0.8, 0.2}, {0.4, -0.3, 0.1}};

std::shared_ptr<ShellSection> neoHookean(double lambda) {
    return std::make_shared<NeoHookeanSection>(2e5, lambda, 0.1);
}

// The balloon of Kiendl et al. 2015: radius 10, thickness 0.1, mu 4.225e5.
constexpr double mu = 4.225e5;

double balloonPressure(double stretch) {
    return 2 * 0.1 / 10 * mu * (1 / stretch - std::pow(stretch, -7));
}

ShellDescription balloon() {
    const geometry::NurbsSurface octant =
        geometry::bezierPieces(geometry::sphere({0, 0, 0}, 10))[4];
    ShellDescription description = onePatch(octant, 3, 6, 6, 0.1, {3 * mu, 0.5, 1});
    description.material.law = MaterialLaw::incompressibleNeoHookean;
    description.edgeSupports = {support(left, {false, true, false}, true),
                                support(right, {true, false, false}, true),
                                support(bottom, {false, false, true}, true)};
    return description;
}

} // namespace

class ShellSections : public testing::TestWithParam<std::shared_ptr<ShellSection>> {};

INSTANTIATE_TEST_SUITE_P(
    All, ShellSections,
    testing::Values(std::make_shared<LinearSection>(ElasticMaterial{2e5, 0.3}, 0.1),
                    neoHookean(3e5), neoHookean(1e9), neoHookean(0), neoHookean(incompressible),
                    std::make_shared<MembraneSection>(neoHookean(3e5), Vector3d(30, 20, 10))));

TEST_P(ShellSections, resultants_and_tangent_are_derivatives_of_the_energy) {
    const ShellSection& section = *GetParam();
    Vector6d strain;
    strain << 0.2, -0.1, 0.15, 0.8, -0.6, 0.3;
    const SectionResponse at = section.response(skewed, strain);
    // Central differences; truncation h^2 and rounding 1e-16 / h are both small.
    const double h = 1e-5;
    for (int k = 0; k < 6; ++k) {
        const SectionResponse above = section.response(skewed, strain + h * Vector6d::Unit(k));
        const SectionResponse below = section.response(skewed, strain - h * Vector6d::Unit(k));
        EXPECT_NEAR((above.energy - below.energy) / (2 * h), at.resultants[k],
                    1e-7 * at.resultants.norm());
        EXPECT_LT(((above.resultants - below.resultants) / (2 * h) - at.tangent.col(k)).norm(),
                  1e-7 * at.tangent.norm());
    }
}

TEST(NeoHookeanSection, is_Hookes_law_at_small_strains) {
    const double E = 2e5, nu = 0.3;
    const NeoHookeanSection section(E / 2 / (1 + nu), E * nu / (1 + nu) / (1 - 2 * nu), 0.1);
    const LinearSection linear(ElasticMaterial{E, nu}, 0.1);
    const FundamentalForms flat{skewed.metric, Vector3d::Zero()};
    const Matrix6d expected = linear.response(flat, Vector6d::Zero()).tangent;
    EXPECT_LT((section.response(flat, Vector6d::Zero()).tangent - expected).norm(),
              1e-12 * expected.norm());
}

TEST(NeoHookeanSection, nearly_incompressible_one_is_close_to_the_incompressible_one) {
    Vector6d strain;
    strain << 0.2, -0.1, 0.15, 0.8, -0.6, 0.3;
    const Vector6d limit = neoHookean(incompressible)->response(skewed, strain).resultants;
    const Vector6d close = neoHookean(2e5 * 1e6)->response(skewed, strain).resultants;
    EXPECT_LT((close - limit).norm(), 1e-5 * limit.norm()); // mu / lambda is 1e-6
}

TEST(NeoHookeanSection, crushed_section_is_told) {
    Vector6d strain = Vector6d::Zero();
    strain[0] = -0.7; // the metric would be negative
    EXPECT_THROW(neoHookean(3e5)->response(skewed, strain), SolverError);
}

TEST(ShellBalloon, inflated_sphere_is_in_balance_with_the_pressure_of_the_formula) {
    // The exact motion is a dilation, which the basis holds; what pressure balances
    // it, through and beyond the maximum of the pressure?
    for (const bool bending : {false, true}) {
        ShellDescription description = balloon();
        description.bending = bending;
        description.loads.pressures = {{{0}, ScalarField::constant(1)}};
        const Shell shell(std::move(description));
        for (const double stretch : {1.01, 1.1, 1.4, 2.0, 4.0, 6.0}) {
            const VectorXd d =
                motion(shell, [&](const Vector3d& X) -> Vector3d { return stretch * X; });
            VectorXd unit = VectorXd::Zero(d.size());
            shell.addFollowerForce(d, 0, unit);
            const double pressure = shell.internalForce(d).force.dot(d) / unit.dot(d);
            // The bending part, (t/R)^2 / 12, is a thousandth of a percent.
            EXPECT_NEAR(pressure, balloonPressure(stretch), 1e-4 * balloonPressure(stretch));
        }
    }
}

TEST(ShellBalloon, inflates_as_the_formula_says) {
    ShellDescription description = balloon();
    const double stretch = 1.2;
    description.loads.pressures = {
        {{0},
         {[=](const geometry::Point&, double t) { return t * balloonPressure(stretch); }, true}}};
    Shell shell(std::move(description));
    const VectorXd d = solveStatic(shell, 4, false);
    for (const double xi : {0.0, 0.4, 1.0}) {
        for (const double eta : {0.0, 0.5, 0.95}) {
            const geometry::KnotVector& u = shell.patches()[0]->surface().u();
            const geometry::KnotVector& v = shell.patches()[0]->surface().v();
            const Vector3d moved = shell
                                       .stateAt(0, u.first() + xi * (u.last() - u.first()),
                                                v.first() + eta * (v.last() - v.first()), d)
                                       .displacement;
            EXPECT_NEAR(moved.norm(), 10 * (stretch - 1), 5e-3 * 10 * (stretch - 1));
        }
    }
}

TEST(ShellDynamics, trapezoidal_rule_keeps_the_energy_of_a_linear_shell) {
    ShellDescription description = exampleShell();
    description.strains = Strains::linear;
    description.edgeSupports = {support(bottom, {true, true, true}, true)};
    description.loads.edgeForces = {
        {{0, top},
         {[](const geometry::Point&, double t) { return Vector3d(t < 0.05, 0, 2); }, true}}};
    Shell shell(std::move(description));
    TimeIntegrator integrator(shell, TimeScheme::newmark(0.25, 0.5), NewtonOptions{}, 0);
    double largest = 0;
    for (int step = 1; step <= 40; ++step) {
        integrator.beginTimeStep(0.01 * step, 0.01);
        integrator.solve();
        integrator.acceptTimeStep();
        const Energies& energies = integrator.energies();
        largest = std::max(largest, energies.kinetic);
        // Rounding of 40 solutions.
        EXPECT_NEAR(energies.kinetic + energies.strain, energies.externalWork, 1e-9 * largest);
    }
    EXPECT_GT(largest, 0);
}
