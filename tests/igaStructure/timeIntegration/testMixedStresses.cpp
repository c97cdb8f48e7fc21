// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/kinematics/shell/exampleShell.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

namespace {

// A cantilever, thickness over length 1e-3, that end moments roll up to a quarter of a
// circle in a few load steps.
constexpr double thickness = 0.01;
constexpr double moment = 0.5 * M_PI / 10 * 1e-6 / 12; // over Young's modulus

Beam thinBeam() {
    ExampleBeam kind;
    kind.elements = 16;
    BeamSection section = kind.section();
    section.thickness = thickness;
    section.axialStiffness = 1e6 * thickness;
    section.bendingStiffness = 1e6 * std::pow(thickness, 3) / 12;
    BeamLoads loads;
    loads.ends.push_back(endMoment(std::to_string(1e12 * moment) + "e-6*t"));
    return {kind.curve(), section, Strains::nonlinear, kind.supports, loads};
}

Shell thinShell() {
    ShellMaterial material;
    material.youngsModulus = 1e6;
    material.density = 1;
    ShellDescription shell =
        onePatch(geometry::plate({0, 0, 0}, {10, 0, 0}, {0, 1, 0}), 4, 16, 1, thickness, material);
    shell.edgeSupports = {support(left, {true, true, true}, true)};
    shell.loads.edgeMoments.push_back(
        {{0, right}, {[](const geometry::Point&, double t) { return 1e6 * moment * t; }, true}});
    return Shell(shell);
}

struct Solution {
    VectorXd displacement;
    int nIterations = 0;
};

Solution solve(StructuralModel& model, bool mixed) {
    NewtonOptions newton{1e-9, 500, false};
    newton.mixedStresses = mixed;
    TimeIntegrator integrator(model, TimeScheme::quasiStatic(), newton, 0);
    Solution solution;
    for (const double time : {0.25, 0.5, 0.75, 1.0}) {
        integrator.beginTimeStep(time, 0.25);
        solution.displacement = integrator.solve();
        integrator.acceptTimeStep();
        solution.nIterations += integrator.nIterations();
    }
    return solution;
}

void expectFewerIterations(StructuralModel& model) {
    const Solution exact = solve(model, false);
    const Solution mixed = solve(model, true);
    EXPECT_LT((mixed.displacement - exact.displacement).norm(), 1e-5 * exact.displacement.norm());
    EXPECT_LT(3 * mixed.nIterations, 2 * exact.nIterations);
}

// At its own displacement the prediction is the stress itself; elsewhere it differs by what
// is quadratic in the distance.
void expectSecondOrder(const StructuralModel& model, double size) {
    const VectorXd at = 0.1 * size * VectorXd::Random(model.nUnknowns());
    const VectorXd change = 0.01 * size * VectorXd::Random(model.nUnknowns());
    const auto difference = [&](double length) {
        SparseMatrix exact;
        SparseMatrix mixed;
        model.internalForce(at, exact);
        model.mixedInternalForce(at, at - length * change, mixed);
        return (exact - mixed).norm() / exact.norm();
    };
    EXPECT_LT(difference(0), 1e-12);
    EXPECT_GT(difference(1), 1e-10);
    EXPECT_NEAR(std::log2(difference(1e-2) / difference(0.5e-2)), 2, 0.05);
}

} // namespace

TEST(MixedStresses, thin_beam_rolls_up_in_fewer_iterations) {
    Beam beam = thinBeam();
    expectFewerIterations(beam);
}

TEST(MixedStresses, thin_shell_rolls_up_in_fewer_iterations) {
    Shell shell = thinShell();
    expectFewerIterations(shell);
}

TEST(MixedStresses, beams_tangent_differs_from_the_exact_one_in_second_order) {
    expectSecondOrder(ExampleBeam().build(), 1);
}

TEST(MixedStresses, shells_tangent_differs_from_the_exact_one_in_second_order) {
    expectSecondOrder(Shell(exampleShell()), 0.1);
    ShellDescription neoHookean = exampleShell();
    neoHookean.material.law = MaterialLaw::neoHookean;
    expectSecondOrder(Shell(neoHookean), 0.1);
}
