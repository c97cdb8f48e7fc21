// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes.hpp"

#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/projection/SurfaceProjector.hpp"
#include "geometry/spline/refinement.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay::structure {

using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::TrimmedPatch;
using geometry::TrimmingLoop;

namespace {

// Curves of a whole patch.
enum Rim { bottom = 0, right = 1, top = 2, left = 3 };

EdgeSupport support(Rim rim, std::array<bool, 3> fixed, bool clamped = false) {
    return {{{0, rim}}, fixed, clamped};
}

ShellDescription onePatch(const geometry::NurbsSurface& surface, int degree, int nU, int nV,
                          double thickness, const ShellMaterial& material) {
    const TrimmedPatch patch(surface, "shell");
    return {geometry::BrepModel({{patch.refined(degree, degree, nU, nV)}}), {thickness}, material};
}

Vector3d onRoof(double degrees, double z) {
    const double angle = degrees * M_PI / 180;
    return {25 * std::cos(angle), 25 * std::sin(angle), z};
}

geometry::NurbsSurface roofSurface(double from, double to, double margin = 0) {
    return geometry::cylinderPatch({0, 0, -margin}, 25, 50 + 2 * margin, from * M_PI / 180,
                                   to * M_PI / 180);
}

// Scordelis and Lo: the middle of the free edge sinks.
Scene roof(std::string name, ShellDescription description) {
    description.strains = Strains::linear;
    for (int face = 0; face < static_cast<int>(description.thickness.size()); ++face) {
        description.loads.tractions.push_back({face, VectorField::constant({0, -90, 0})});
        description.edgeSupports.push_back({{{face, bottom}, {face, top}}, {true, true, false}});
    }
    const geometry::SurfaceProjector projector(description.model.patch(0).surface());
    const geometry::SurfaceProjection corner = projector.closest(onRoof(50, 0));
    const geometry::SurfaceProjection tip = projector.closest(onRoof(50, 25));
    description.pointSupports = {{0, {corner.xi, corner.eta}, {false, false, true}}};
    return {std::move(name), std::move(description),
            [tip](const Shell& shell, const VectorXd& d) {
                return -displacementAt(shell, tip.xi, tip.eta, d)[1];
            },
            0.3006, 5e-3};
}

const ShellMaterial concrete{4.32e8, 0, 1};

ShellDescription trimmedRoof(int n) {
    const geometry::NurbsSurface surface = roofSurface(38, 142, 7);
    const geometry::SurfaceProjector projector(surface);
    const Vector3d corners[4] = {onRoof(50, 0), onRoof(130, 0), onRoof(130, 50), onRoof(50, 50)};
    std::vector<geometry::NurbsCurve> rim;
    for (int k = 0; k < 4; ++k) {
        const auto a = projector.closest(corners[k]);
        const auto b = projector.closest(corners[(k + 1) % 4]);
        rim.push_back(geometry::line({a.xi, a.eta, 0}, {b.xi, b.eta, 0}));
    }
    const TrimmedPatch patch(surface, {TrimmingLoop(geometry::LoopKind::outer, rim)}, "roof");
    return {geometry::BrepModel({{patch.refined(3, 3, n, n)}}), {0.25}, concrete};
}

ShellDescription threePatchRoof(int n) {
    const std::vector<geometry::BrepFace> faces = {
        {TrimmedPatch(roofSurface(50, 74), "a").refined(3, 3, n / 2, n)},
        {TrimmedPatch(roofSurface(74, 102), "b").refined(2, 2, n + 1, 2 * n + 1)},
        {TrimmedPatch(roofSurface(102, 130), "c").refined(4, 4, n / 2, n - 1)}};
    return {geometry::BrepModel(faces, geometry::coincidentEdges(faces, 1e-6)),
            {0.25, 0.25, 0.25},
            concrete};
}

Scene pinchedCylinder(int n) {
    ShellDescription cylinder = onePatch(geometry::cylinderPatch({0, 0, 0}, 300, 300, 0, M_PI / 2),
                                         4, n, n, 3, {3e6, 0.3, 1});
    cylinder.strains = Strains::linear;
    cylinder.edgeSupports = {
        support(bottom, {true, true, false}), support(top, {false, false, true}, true),
        support(left, {false, true, false}, true), support(right, {true, false, false}, true)};
    cylinder.loads.pointForces = {{0, {0, 1}, VectorField::constant({-0.25, 0, 0})}};
    return {
        "pinched cylinder", std::move(cylinder),
        [](const Shell& shell, const VectorXd& d) { return -displacementAt(shell, 0, 1, d)[0]; },
        1.8248e-5, 5e-3};
}

geometry::NurbsSurface octant() {
    return geometry::bezierPieces(geometry::sphere({0, 0, 0}, 10))[4];
}

Scene hemisphere(int n) {
    ShellDescription shell = onePatch(octant(), 4, n, n, 0.04, {6.825e7, 0.3, 1});
    shell.strains = Strains::linear;
    shell.edgeSupports = {support(left, {false, true, false}, true),
                          support(right, {true, false, false}, true)};
    const geometry::KnotVector u = octant().u();
    const geometry::KnotVector v = octant().v();
    shell.pointSupports = {{0, {u.first(), v.last()}, {false, false, true}}};
    shell.loads.pointForces = {{0, {u.first(), v.first()}, VectorField::constant({1, 0, 0})},
                               {0, {u.last(), v.first()}, VectorField::constant({0, -1, 0})}};
    const double xi = u.first();
    const double eta = v.first();
    return {"pinched closed hemisphere", std::move(shell),
            [=](const Shell& s, const VectorXd& d) { return displacementAt(s, xi, eta, d)[0]; },
            0.0924, 5e-3};
}

// z = x^2 - y^2 over the unit square around the origin, clamped at x = -1/2.
Scene hypar(double thickness, double reference, int n) {
    geometry::Points points(9, 3);
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            // Bernstein coefficients of x^2 on [-1/2, 1/2] are 1/4, -1/4, 1/4.
            const double squareX = i == 1 ? -0.25 : 0.25;
            const double squareY = j == 1 ? -0.25 : 0.25;
            points.row(i + 3 * j) << 0.5 * (i - 1), 0.5 * (j - 1), squareX - squareY;
        }
    }
    const geometry::KnotVector quadratic = geometry::KnotVector::uniform(2, 1);
    ShellDescription shell = onePatch(geometry::NurbsSurface(quadratic, quadratic, points), 4, n, n,
                                      thickness, {2e11, 0.3, 1});
    shell.strains = Strains::linear;
    shell.edgeSupports = {support(left, {true, true, true}, true)};
    shell.loads.tractions = {{0, VectorField::constant({0, 0, -8000 * thickness})}};
    return {fmt::format("clamped hypar t/L {:g}", thickness), std::move(shell),
            [](const Shell& s, const VectorXd& d) { return -displacementAt(s, 1, 0.5, d)[2]; },
            reference, 2e-2};
}

} // namespace

Vector3d displacementAt(const Shell& shell, double xi, double eta, const VectorXd& displacement) {
    return shell.stateAt(0, xi, eta, displacement).displacement;
}

std::vector<Scene> roofScenes(int n) {
    std::vector<Scene> scenes;
    scenes.push_back(
        roof("Scordelis-Lo roof", onePatch(roofSurface(50, 130), 3, 8 * n, 8 * n, 0.25, concrete)));
    scenes.push_back(roof("Scordelis-Lo roof cut out of a larger patch", trimmedRoof(10 * n)));
    scenes.push_back(
        roof("Scordelis-Lo roof of three patches that do not match", threePatchRoof(9 * n)));
    return scenes;
}

std::vector<Scene> linearScenes(bool isQuick) {
    const int n = isQuick ? 1 : 2;
    std::vector<Scene> scenes = roofScenes(n);
    scenes.push_back(pinchedCylinder(16 * n));
    scenes.push_back(hemisphere(12 * n));
    scenes.push_back(hypar(1e-2, 9.3355e-5, 16 * n));
    scenes.push_back(hypar(1e-3, 6.3941e-3, 24 * n));
    scenes.push_back(hypar(1e-4, 5.2988e-1, 16 * n + 32));
    return scenes;
}

ShellDescription shearedCantilever() {
    ShellDescription plate =
        onePatch(geometry::rectangle({0, 0, 0}, 10, 1), 3, 16, 1, 0.1, {1.2e6, 0, 1});
    plate.edgeSupports = {support(left, {true, true, true}, true)};
    plate.loads.edgeForces = {
        {{0, right},
         {[](const geometry::Point&, double t) { return Vector3d(0, 0, 4 * t); }, true}}};
    return plate;
}

ShellDescription rolledCantilever() {
    ShellDescription plate =
        onePatch(geometry::rectangle({0, 0, 0}, 12, 1), 4, 16, 1, 0.1, {1.2e6, 0, 1});
    plate.edgeSupports = {support(left, {true, true, true}, true)};
    plate.loads.edgeMoments = {
        {{0, right}, {[](const geometry::Point&, double t) { return -50 * M_PI / 3 * t; }, true}}};
    return plate;
}

double balloonPressure(double stretch) {
    return 2 * 0.1 / 10 * 4.225e5 * (1 / stretch - std::pow(stretch, -7));
}

ShellDescription balloon(const ScalarField& pressure) {
    ShellDescription shell = onePatch(octant(), 3, 8, 8, 0.1, {3 * 4.225e5, 0.5, 1});
    shell.material.law = MaterialLaw::incompressibleNeoHookean;
    shell.edgeSupports = {support(left, {false, true, false}, true),
                          support(right, {true, false, false}, true),
                          support(bottom, {false, false, true}, true)};
    shell.loads.pressures = {{{0}, pressure}};
    return shell;
}

ShellDescription balloonHalves(const ScalarField& pressure, int n) {
    const geometry::KnotVector u = octant().u();
    const std::vector<geometry::NurbsSurface> halves =
        geometry::bezierPieces(geometry::insertKnots(octant(), {0.5 * (u.first() + u.last())}, {}));
    ShellDescription shell{
        geometry::BrepModel({{TrimmedPatch(halves[0], "first").refined(3, 3, n, n)},
                             {TrimmedPatch(halves[1], "second").refined(3, 3, n + 1, n + 3)}},
                            {{"joint", {{0, right}, {1, left}}}}),
        {0.1, 0.1},
        {3 * 4.225e5, 0.5, 1}};
    shell.bending = false;
    shell.material.law = MaterialLaw::incompressibleNeoHookean;
    shell.edgeSupports = {{{{0, left}}, {false, true, false}},
                          {{{1, right}}, {true, false, false}},
                          {{{0, bottom}, {1, bottom}}, {false, false, true}}};
    shell.loads.pressures = {{{0, 1}, pressure}};
    return shell;
}

double worstStretchOfJoint(const Shell& shell, const VectorXd& displacement, double expected) {
    double worst = expected;
    for (int face = 0; face < 2; ++face) {
        const geometry::NurbsSurface& surface = shell.patches()[face]->surface();
        const double xi = face == 0 ? surface.u().last() : surface.u().first();
        constexpr int nPlaces = 40;
        for (int k = 0; k <= nPlaces; ++k) {
            // The last place is beside the pole, where parameters have no meaning.
            const double share = 0.99 * k / nPlaces;
            const double eta = (1 - share) * surface.v().first() + share * surface.v().last();
            const Vector3d x =
                surface.point(xi, eta) + shell.stateAt(face, xi, eta, displacement).displacement;
            const double stretch = x.norm() / 10;
            if (std::abs(stretch - expected) > std::abs(worst - expected)) {
                worst = stretch;
            }
        }
    }
    return worst;
}

} // namespace tokay::structure
