// SPDX-License-Identifier: GPL-3.0-or-later
// Edges that are held or joined weakly, where inertia decides: in the first time steps of a body
// that starts from rest, the more the thinner and softer it is and the shorter the step.
#include "exampleShell.hpp"

#include <gtest/gtest.h>

#include <ostream>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Parameters;

namespace {

/// A square of side 1, clamped all around, cut out of one of side 1.5 by lines at an angle:
/// the floor of tutorials/lidDrivenCavity at 30 degrees.
struct HeldFloor {
    EdgeMethod method;
    int degree;
    int nElements;
    double degrees; ///< of the angle
    double deltaT = 0.05;
    double thickness = 0.002;
};

std::ostream& operator<<(std::ostream& out, const HeldFloor& floor) {
    return out << "method " << static_cast<int>(floor.method) << " degree " << floor.degree
               << " on " << floor.nElements << " elements at " << floor.degrees
               << " degrees, deltaT " << floor.deltaT << ", thickness " << floor.thickness;
}

constexpr double patchSize = 1.5;

geometry::TrimmedPatch turnedSquare(double degrees) {
    const auto corner = [&](int k) -> geometry::Point {
        const double angle = (degrees - 135 + 90 * k) * M_PI / 180;
        const double radius = std::sqrt(0.5) / patchSize;
        return {0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0};
    };
    std::vector<geometry::NurbsCurve> lines;
    for (int k = 0; k < 4; ++k) {
        lines.push_back(geometry::line(corner(k), corner(k + 1)));
    }
    return {geometry::rectangle({-0.75, -0.75, 0}, patchSize, patchSize),
            {geometry::TrimmingLoop(geometry::LoopKind::outer, std::move(lines))},
            "floor"};
}

ShellDescription describe(const HeldFloor& floor) {
    const int n = floor.nElements;
    ShellDescription shell{
        geometry::BrepModel(
            {{turnedSquare(floor.degrees).refined(floor.degree, floor.degree, n, n)}}),
        {floor.thickness},
        {250, 0, 500}};
    shell.strains = floor.method == EdgeMethod::nitsche ? Strains::linear : Strains::nonlinear;
    shell.edgeMethod = floor.method;
    for (int side = 0; side < 4; ++side) {
        shell.edgeSupports.push_back({{{0, side}}, {true, true, true}, true});
    }
    shell.loads.tractions.push_back({0, VectorField::constant({0, 0, 1e-3})});
    return shell;
}

/// Largest displacement of the edge, corners included, over that of the floor.
double slip(const Shell& shell, const VectorXd& displacement) {
    double ofEdge = 0, ofFloor = 0;
    const geometry::TrimmedPatch& patch = shell.patches()[0]->patch();
    const auto moved = [&](const Parameters& at) {
        return shell.displacementAt(0, at, 0, displacement).norm();
    };
    for (const geometry::NurbsCurve& line : patch.loops()[0].curves()) {
        for (int k = 0; k <= 64; ++k) {
            ofEdge = std::max(ofEdge, moved(line.point(k / 64.0).head<2>()));
        }
    }
    for (int k = 0; k < 30 * 30; ++k) {
        const Parameters at((k % 30 + 0.5) / 30, (k / 30 + 0.5) / 30);
        ofFloor = patch.contains(at) ? std::max(ofFloor, moved(at)) : ofFloor;
    }
    return ofEdge / ofFloor;
}

/// The largest one of the first steps.
double firstSlip(Shell& shell, double deltaT) {
    TimeIntegrator integrator(shell, TimeScheme::generalisedAlpha(0.8), NewtonOptions(), 0);
    double largest = 0;
    for (int step = 1; step <= 4; ++step) {
        integrator.beginTimeStep(step * deltaT, deltaT);
        integrator.solve();
        integrator.acceptTimeStep();
        largest = std::max(largest, slip(shell, integrator.state().displacement));
    }
    return largest;
}

class HeldEdge : public testing::TestWithParam<HeldFloor> {};

} // namespace

/// The edge stays where it is. What an element's inertia is to the springs' is a thousandth, and
/// next to the edge the floor's shape has several times that; up to the hundredth of which a
/// coupled run warns. (Springs by the elastic stiffness alone: 0.02 to 1.2.)
TEST_P(HeldEdge, stays_in_the_first_time_steps_at_corners_and_slivers_too) {
    Shell shell(describe(GetParam()));
    EXPECT_LT(firstSlip(shell, GetParam().deltaT), 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    ShellInertia, HeldEdge,
    testing::Values(HeldFloor{EdgeMethod::lagrange, 3, 24, 30}, // that of the tutorial
                    HeldFloor{EdgeMethod::lagrange, 3, 12, 30},
                    HeldFloor{EdgeMethod::lagrange, 2, 24, 45}, // corners on knot lines
                    HeldFloor{EdgeMethod::lagrange, 4, 12, 3},  // slivers along all sides
                    HeldFloor{EdgeMethod::lagrange, 3, 24, 3},
                    HeldFloor{EdgeMethod::lagrange, 3, 24, 30, 0.0005},
                    HeldFloor{EdgeMethod::lagrange, 3, 24, 30, 0.05, 1e-4},
                    HeldFloor{EdgeMethod::penalty, 3, 24, 30}));
