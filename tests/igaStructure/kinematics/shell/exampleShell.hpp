// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <cmath>
#include <random>

namespace tokay::structure {

/// Trimming curves of a whole patch.
enum Rim { bottom = 0, right = 1, top = 2, left = 3 };

inline EdgeSupport support(Rim rim, std::array<bool, 3> fixed, bool clamped = false) {
    return {{{0, rim}}, fixed, clamped};
}

inline ShellDescription onePatch(const geometry::NurbsSurface& surface, int degree, int nU, int nV,
                                 double thickness, const ShellMaterial& material) {
    const geometry::TrimmedPatch patch(surface, "shell");
    return {geometry::BrepModel({{patch.refined(degree, degree, nU, nV)}}), {thickness}, material};
}

/// Half of a cylinder (rational), its bottom edge held; large rotations allowed.
inline ShellDescription exampleShell() {
    ShellMaterial material;
    material.youngsModulus = 2e5;
    material.poissonsRatio = 0.3;
    material.density = 1000;
    return onePatch(geometry::cylinderPatch({1, 2, 3}, 2, 3, 0.3, 0.3 + M_PI), 3, 2, 3, 0.1,
                    material);
}

inline Eigen::VectorXd randomMotion(Eigen::Index size, double amplitude) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    Eigen::VectorXd vector(size);
    for (double& value : vector) {
        value = uniform(generator);
    }
    return vector;
}

/// Displacement of all nodes by a map of space.
template <class Map>
Eigen::VectorXd motion(const Shell& shell, const Map& map) {
    Eigen::VectorXd displacement(shell.nUnknowns());
    for (int k = 0; k < shell.nodes().count(); ++k) {
        const Eigen::Vector3d X = shell.nodes().positions.row(k);
        displacement.segment<3>(3 * k) = map(X) - X;
    }
    return displacement;
}

/// Displacement under static loads, reached in equal load steps to time 1.
inline Eigen::VectorXd solveStatic(Shell& shell, int nSteps = 1, bool lineSearch = true) {
    NewtonOptions newton;
    newton.lineSearch = lineSearch;
    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), newton, 0);
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(static_cast<double>(step) / nSteps, 1.0 / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    return integrator.state().displacement;
}

} // namespace tokay::structure
