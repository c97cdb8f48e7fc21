// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleShell.hpp"

#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double published = 5e-3; // relative; what published values are worth

Vector3d displacementAt(const Shell& shell, double xi, double eta, const VectorXd& d) {
    return shell.stateAt(0, xi, eta, d).displacement;
}

// A thin shell's residual grows before it falls: shortened updates only cost iterations.
NewtonOptions wholeUpdates() {
    NewtonOptions newton;
    newton.lineSearch = false;
    return newton;
}

} // namespace

TEST(ShellBenchmarks, roof_of_Scordelis_and_Lo) {
    ShellDescription roof =
        onePatch(geometry::cylinderPatch({0, 0, 0}, 25, 50, 50 * M_PI / 180, 130 * M_PI / 180), 3,
                 8, 8, 0.25, {4.32e8, 0, 1});
    roof.strains = Strains::linear;
    roof.edgeSupports = {support(bottom, {true, true, false}), support(top, {true, true, false})};
    roof.pointSupports = {{0, {0, 0}, {false, false, true}}};
    roof.loads.tractions = {{0, VectorField::constant({0, -90, 0})}};
    Shell shell(std::move(roof));
    EXPECT_NEAR(-displacementAt(shell, 0, 0.5, solveStatic(shell))[1], 0.3006, published * 0.3006);
}

TEST(ShellBenchmarks, pinched_cylinder_with_diaphragms) {
    // An eighth: one end on a diaphragm, the others are planes of symmetry.
    ShellDescription cylinder = onePatch(geometry::cylinderPatch({0, 0, 0}, 300, 300, 0, M_PI / 2),
                                         4, 16, 16, 3, {3e6, 0.3, 1});
    cylinder.strains = Strains::linear;
    cylinder.edgeSupports = {
        support(bottom, {true, true, false}), support(top, {false, false, true}, true),
        support(left, {false, true, false}, true), support(right, {true, false, false}, true)};
    cylinder.loads.pointForces = {{0, {0, 1}, VectorField::constant({-0.25, 0, 0})}};
    Shell shell(std::move(cylinder));
    EXPECT_NEAR(-displacementAt(shell, 0, 1, solveStatic(shell))[0], 1.8248e-5,
                published * 1.8248e-5);
}

TEST(ShellBenchmarks, pinched_closed_hemisphere) {
    // A quarter with its pole, between two planes of symmetry.
    const geometry::NurbsSurface octant =
        geometry::bezierPieces(geometry::sphere({0, 0, 0}, 10))[4];
    ShellDescription hemisphere = onePatch(octant, 4, 12, 12, 0.04, {6.825e7, 0.3, 1});
    hemisphere.strains = Strains::linear;
    hemisphere.edgeSupports = {support(left, {false, true, false}, true),
                               support(right, {true, false, false}, true)};
    const geometry::KnotVector& u = octant.u();
    const geometry::KnotVector& v = octant.v();
    hemisphere.pointSupports = {{0, {u.first(), v.last()}, {false, false, true}}};
    hemisphere.loads.pointForces = {{0, {u.first(), v.first()}, VectorField::constant({1, 0, 0})},
                                    {0, {u.last(), v.first()}, VectorField::constant({0, -1, 0})}};
    Shell shell(std::move(hemisphere));
    const VectorXd d = solveStatic(shell);
    EXPECT_NEAR(displacementAt(shell, u.first(), v.first(), d)[0], 0.0924, published * 0.0924);
    EXPECT_NEAR(-displacementAt(shell, u.last(), v.first(), d)[1], 0.0924, published * 0.0924);
}

TEST(ShellBenchmarks,
     cantilever_bends_as_a_beam_from_a_tenth_to_a_hundred_thousandth_of_its_length) {
    for (const Strains strains : {Strains::linear, Strains::nonlinear}) {
        for (const double thickness : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
            // Cubic functions hold the exact deflection; Poisson's ratio 0.
            const double wanted = 1e-3 * thickness;
            const double force = 3 * 1e6 * std::pow(thickness, 3) / 12 * wanted;
            ShellDescription plate =
                onePatch(geometry::rectangle({0, 0, 0}, 1, 1), 3, 6, 2, thickness, {1e6, 0, 1});
            plate.strains = strains;
            plate.edgeSupports = {support(left, {true, true, true}, true)};
            plate.loads.edgeForces = {{{0, right}, VectorField::constant({0, 0, force})}};
            Shell shell(std::move(plate));
            const double tip = displacementAt(shell, 1, 0.5, solveStatic(shell))[2];
            EXPECT_NEAR(tip, wanted, 1e-6 * wanted) << thickness;
        }
    }
}

TEST(ShellBenchmarks, nearly_incompressible_plate_is_as_stiff_as_its_modulus_says) {
    // Bent to a cylinder: E t^3 / 12 / (1 - nu^2) with nu 0.4999.
    ShellDescription plate =
        onePatch(geometry::rectangle({0, 0, 0}, 1, 1), 3, 6, 2, 0.01, {1e6, 0.4999, 1});
    plate.strains = Strains::linear;
    plate.edgeSupports = {support(left, {true, true, true}, true),
                          support(bottom, {false, true, false}, true),
                          support(top, {false, true, false}, true)};
    plate.penalty = 1e7;
    plate.loads.edgeForces = {{{0, right}, VectorField::constant({0, 0, 1e-3})}};
    Shell shell(std::move(plate));
    const double D = 1e6 * 1e-6 / 12 / (1 - 0.4999 * 0.4999);
    const double expected = 1e-3 / (3 * D);
    EXPECT_NEAR(displacementAt(shell, 1, 0.5, solveStatic(shell))[2], expected, 1e-5 * expected);
}

TEST(ShellBenchmarks, cantilever_with_end_shear) {
    // Sze, Liu & Lo 2004: tip, -ux and uz, in steps of 0.05 of the largest load.
    const double expected[20][2] = {{0.026, 0.663}, {0.103, 1.309}, {0.224, 1.922}, {0.381, 2.493},
                                    {0.563, 3.015}, {0.763, 3.488}, {0.971, 3.912}, {1.184, 4.292},
                                    {1.396, 4.631}, {1.604, 4.933}, {1.807, 5.202}, {2.002, 5.444},
                                    {2.190, 5.660}, {2.370, 5.855}, {2.541, 6.031}, {2.705, 6.190},
                                    {2.861, 6.335}, {3.010, 6.467}, {3.151, 6.588}, {3.286, 6.698}};
    ShellDescription plate =
        onePatch(geometry::rectangle({0, 0, 0}, 10, 1), 3, 12, 1, 0.1, {1.2e6, 0, 1});
    plate.edgeSupports = {support(left, {true, true, true}, true)};
    plate.loads.edgeForces = {
        {{0, right},
         {[](const geometry::Point&, double t) { return Vector3d(0, 0, 4 * t); }, true}}};
    Shell shell(std::move(plate));
    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), wholeUpdates(), 0);
    for (int step = 1; step <= 20; ++step) {
        integrator.beginTimeStep(0.05 * step, 0.05);
        integrator.solve();
        integrator.acceptTimeStep();
        const Vector3d tip = displacementAt(shell, 1, 0.5, integrator.state().displacement);
        const double* wanted = expected[step - 1];
        // Published to three decimals.
        EXPECT_NEAR(-tip[0], wanted[0], published * wanted[0] + 5e-4);
        EXPECT_NEAR(tip[2], wanted[1], published * wanted[1] + 5e-4);
    }
}

TEST(ShellBenchmarks, cantilever_rolled_up_to_a_circle) {
    ShellDescription plate =
        onePatch(geometry::rectangle({0, 0, 0}, 12, 1), 4, 16, 1, 0.1, {1.2e6, 0, 1});
    // Free to leave its plane: the moment has no potential.
    plate.edgeSupports = {support(left, {true, true, true}, true)};
    const double fullCircle = 50 * M_PI / 3;
    plate.loads.edgeMoments = {
        {{0, right}, {[=](const geometry::Point&, double t) { return -fullCircle * t; }, true}}};
    Shell shell(std::move(plate));
    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), wholeUpdates(), 0);
    for (int step = 1; step <= 20; ++step) {
        integrator.beginTimeStep(0.05 * step, 0.05);
        integrator.solve();
        integrator.acceptTimeStep();
        const Vector3d tip = displacementAt(shell, 1, 0.5, integrator.state().displacement);
        const double kL = 2 * M_PI * 0.05 * step;
        EXPECT_NEAR(tip[0], 12 * (std::sin(kL) / kL - 1), 1e-3 * 12) << step;
        EXPECT_NEAR(tip[2], 12 * (1 - std::cos(kL)) / kL, 1e-3 * 12) << step;
    }
}
