// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleShell.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"

#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

const ScalarField uniform = ScalarField::constant(300);
const ScalarField growingWithHeight{[](const geometry::Point& x, double) { return 100 * x[2]; },
                                    false, true};

MatrixXd followerDerivative(const StructuralModel& model, const VectorXd& d) {
    SparseMatrix tangent;
    model.internalForce(VectorXd::Zero(d.size()), tangent);
    const MatrixXd before = tangent;
    model.subtractFollowerDerivative(d, 0, tangent);
    return before - MatrixXd(tangent);
}

MatrixXd followerDifferences(const StructuralModel& model, const VectorXd& d, double h) {
    MatrixXd differences(d.size(), d.size());
    for (Eigen::Index k = 0; k < d.size(); ++k) {
        VectorXd change = VectorXd::Zero(d.size());
        model.addFollowerForce(d + h * VectorXd::Unit(d.size(), k), 0, change);
        VectorXd below = VectorXd::Zero(d.size());
        model.addFollowerForce(d - h * VectorXd::Unit(d.size(), k), 0, below);
        differences.col(k) = (change - below) / (2 * h);
    }
    return differences;
}

// Part of a matrix that is not symmetric, free unknowns only, over the whole.
double asymmetry(const StructuralModel& model, MatrixXd matrix) {
    for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
        if (model.fixed()[k]) {
            matrix.row(k).setZero();
            matrix.col(k).setZero();
        }
    }
    return (matrix - matrix.transpose()).norm() / matrix.norm();
}

VectorXd allowedMotion(const StructuralModel& model, double amplitude) {
    VectorXd d = randomMotion(model.nUnknowns(), amplitude);
    for (Eigen::Index k = 0; k < d.size(); ++k) {
        d[k] = model.fixed()[k] ? 0 : d[k];
    }
    return d;
}

struct Loaded {
    const char* name;
    bool isSymmetric;
    ShellDescription shell;
};

std::vector<Loaded> loadedShells() {
    std::vector<Loaded> all;
    const auto add = [&](const char* name, bool isSymmetric, auto change) {
        all.push_back({name, isSymmetric, exampleShell()});
        change(all.back().shell);
    };
    const auto hold = [](ShellDescription& shell, std::array<bool, 3> onEnds) {
        shell.loads.pressures = {{{0}, uniform}};
        shell.edgeSupports = {support(left, {true, true, false}),
                              support(right, {true, true, true}), support(bottom, onEnds),
                              support(top, onEnds)};
    };
    add("free rim", false, [](ShellDescription& shell) {
        shell.loads.pressures = {{{0}, uniform}};
    });
    add("rim held by two components", true, [&](ShellDescription& shell) {
        hold(shell, {true, true, false});
    });
    add("ends in planes of symmetry", true, [&](ShellDescription& shell) {
        hold(shell, {false, false, true});
    });
    add("one component along a curved edge", false, [&](ShellDescription& shell) {
        hold(shell, {true, false, false});
    });
    add("pressure of water", false, [&](ShellDescription& shell) {
        hold(shell, {true, true, true});
        shell.loads.pressures = {{{0}, growingWithHeight}};
    });
    add("line moment", false, [](ShellDescription& shell) {
        shell.loads.edgeMoments = {{{0, top}, uniform}};
    });
    return all;
}

} // namespace

TEST(FollowerLoads, derivative_equals_finite_differences_on_any_rim) {
    for (Loaded& loaded : loadedShells()) {
        const Shell shell(std::move(loaded.shell));
        const VectorXd d = randomMotion(shell.nUnknowns(), 0.02 * shell.size());
        const MatrixXd expected = followerDifferences(shell, d, 1e-6 * shell.size());
        EXPECT_LT((followerDerivative(shell, d) - expected).norm(), 1e-7 * expected.norm())
            << loaded.name;
    }
}

TEST(FollowerLoads, shell_says_truly_whether_its_tangent_is_symmetric) {
    for (Loaded& loaded : loadedShells()) {
        const Shell shell(std::move(loaded.shell));
        EXPECT_EQ(shell.hasSymmetricTangent(), loaded.isSymmetric) << loaded.name;
        const MatrixXd derivative =
            followerDerivative(shell, allowedMotion(shell, 0.02 * shell.size()));
        // Four Gauss points do not integrate the products exactly: up to 3e-4.
        EXPECT_EQ(asymmetry(shell, derivative) < 1e-3, loaded.isSymmetric) << loaded.name;
    }
}

TEST(FollowerLoads, joined_patches_under_one_pressure_count_as_closed) {
    const auto half = [](double from, double to, const char* name) {
        return geometry::BrepFace{
            geometry::TrimmedPatch(geometry::cylinderPatch({0, 0, 0}, 1, 1, from, to), name)
                .refined(2, 2, 2, 1)};
    };
    const std::vector<geometry::BrepFace> faces = {half(0, M_PI, "one"),
                                                   half(M_PI, 2 * M_PI, "two")};
    ShellDescription tube{geometry::BrepModel(faces, geometry::coincidentEdges(faces, 1e-6)),
                          {0.1, 0.1},
                          {1e6, 0.3, 1}};
    for (int face : {0, 1}) {
        tube.edgeSupports.push_back({{{face, bottom}, {face, top}}, {false, false, true}, false});
    }
    tube.loads.pressures = {{{0, 1}, uniform}};
    EXPECT_TRUE(Shell(tube).hasSymmetricTangent());
    tube.loads.pressures = {{{0}, uniform}}; // ends at the joint
    EXPECT_FALSE(Shell(tube).hasSymmetricTangent());
    tube.strains = Strains::linear; // which does not see how loads turn
    EXPECT_TRUE(Shell(tube).hasSymmetricTangent());
}

TEST(FollowerLoads, line_says_truly_whether_its_tangent_is_symmetric) {
    struct Case {
        const char* pressure;
        bool heldEnd, isSymmetric;
    };
    for (const Case& kind :
         {Case{"7", true, true}, Case{"7*t+7", false, false}, Case{"7*x", true, false}}) {
        ExampleBeam line;
        line.arc = true;
        line.loads.ends.push_back(endMoment("30"));
        line.loads.pressures.emplace_back(kind.pressure, "");
        line.supports.push_back({BeamEnd::end, kind.heldEnd, false, false});
        const Beam beam = line.build();
        EXPECT_EQ(beam.hasSymmetricTangent(), kind.isSymmetric) << kind.pressure;
        const VectorXd d = allowedMotion(beam, 0.3);
        const MatrixXd derivative = followerDerivative(beam, d);
        EXPECT_EQ(asymmetry(beam, derivative) < 1e-6, kind.isSymmetric) << kind.pressure;
        const MatrixXd expected = followerDifferences(beam, d, 1e-5);
        EXPECT_LT((derivative - expected).norm(), 1e-7 * expected.norm()) << kind.pressure;
    }
}

namespace {

// From the last residual above 1e-3 on, three iterations get below 1e-8; linear
// convergence would need a contraction of 0.02 in each.
void expectQuadratic(StructuralModel& model, int nSteps) {
    NewtonOptions newton;
    newton.tolerance = 1e-11;
    newton.lineSearch = false;
    TimeIntegrator integrator(model, TimeScheme::quasiStatic(), newton, 0);
    EXPECT_EQ(integrator.solver().name(), "UMFPACK");
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(static_cast<double>(step) / nSteps, 1.0 / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
        const std::vector<double>& residuals = integrator.residuals();
        const auto large = std::find_if(residuals.rbegin(), residuals.rend(),
                                        [](double residual) { return residual > 1e-3; });
        ASSERT_NE(large, residuals.rend());
        const auto nSmall = large - residuals.rbegin();
        EXPECT_LT(*(nSmall > 3 ? large - 3 : residuals.rbegin()), 1e-8) << step;
    }
}

} // namespace

TEST(FollowerLoads, Newton_is_quadratic_for_a_cantilevered_strip_under_pressure) {
    ShellDescription strip =
        onePatch(geometry::rectangle({0, 0, 0}, 1, 0.3), 3, 6, 2, 0.02, {1e6, 0.3, 1});
    strip.edgeSupports = {support(left, {true, true, true}, true)};
    strip.loads.pressures = {{{0}, {[](const geometry::Point&, double t) { return 8 * t; }, true}}};
    Shell shell(std::move(strip));
    expectQuadratic(shell, 4);
    // The exact curve lies close to the beam's: p L^3 / E I is 12, half a turn.
    EXPECT_GT(shell.stateAt(0, 1, 0.5, solveStatic(shell, 4, false)).displacement[2], 0.3);
}

TEST(FollowerLoads, Newton_is_quadratic_for_a_cantilever_beam_under_pressure) {
    ExampleBeam kind;
    kind.loads.pressures.emplace_back("-0.3*t", "");
    Beam line = kind.build();
    expectQuadratic(line, 4);
}
