// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/kinematics/beam/Beam.hpp"
#include "igaStructure/kinematics/beam/planeVectors.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <cmath>
#include <string>

namespace tokay::structure {

/// A cantilever of length 10, thickness 0.1 and width 1, E = 1.2e6, along x; or
/// a quarter of a circle of radius 10 that leaves its clamp along y.
struct ExampleBeam {
    Strains strains = Strains::nonlinear;
    bool arc = false;
    int degree = 4;
    int elements = 8;
    double length = 10;
    bool rotaryInertia = false;
    BeamLoads loads = {};
    std::vector<BeamSupport> supports = {{BeamEnd::start, true, true, true}};

    BeamSection section() const {
        BeamSection section;
        section.thickness = 0.1;
        section.axialStiffness = 1.2e6 * 0.1;
        section.bendingStiffness = 1.2e6 * std::pow(0.1, 3) / 12;
        section.mass = 100 * 0.1;
        section.rotaryInertia = rotaryInertia ? 100 * std::pow(0.1, 3) / 12 : 0;
        return section;
    }
    geometry::NurbsCurve curve() const {
        return geometry::refine(arc ? geometry::arc({0, 0, 0}, 10, 0, 0.5 * M_PI)
                                    : geometry::line({0, 0, 0}, {length, 0, 0}),
                                degree, elements);
    }
    Beam build() const { return {curve(), section(), strains, supports, loads}; }
};

inline EndLoad endForce(const std::string& x, const std::string& y) {
    return {BeamEnd::end, std::vector<Formula>{Formula(x, ""), Formula(y, "")}, std::nullopt};
}

inline EndLoad endMoment(const std::string& moment) {
    return {BeamEnd::end, std::nullopt, Formula(moment, "")};
}

/// Static displacements after each of equal load steps from time 0 to 1.
inline std::vector<Eigen::VectorXd> loadSteps(Beam& line, int nSteps) {
    TimeIntegrator integrator(line, TimeScheme::quasiStatic(), NewtonOptions{1e-10, 40, true}, 0);
    std::vector<Eigen::VectorXd> displacements;
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(static_cast<double>(step) / nSteps, 1.0 / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
        displacements.push_back(integrator.state().displacement);
    }
    return displacements;
}

/// Displacement of the end of the axis, an interpolated control point.
inline Eigen::Vector2d endDisplacement(const Beam& line, const Eigen::VectorXd& unknowns) {
    return line.controlDisplacements(unknowns).tail<2>();
}

/// Current tangent at a parameter, of length one.
inline Eigen::Vector2d tangentAt(const Beam& line, double xi, const Eigen::VectorXd& unknowns) {
    const Eigen::VectorXd all = line.controlDisplacements(unknowns);
    const geometry::CurveBasis basis = line.curve().basis(xi, 1);
    Eigen::Vector2d tangent = line.curve().derivatives(xi, 1).row(1).head<2>();
    for (int a = 0; a < basis.N.cols(); ++a) {
        tangent += basis.N(1, a) * all.segment<2>(2 * (basis.first + a));
    }
    return tangent.normalized();
}

} // namespace tokay::structure
