// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/primitives/primitives.hpp"
#include "geometry/primitives/volumePrimitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/kinematics/shell/exampleShell.hpp"
#include "igaStructure/kinematics/solid/Solid.hpp"

#include <ostream>

namespace tokay::structure {

/// Kinds of solids that tests go through.
struct SolidKind {
    Strains strains;
    MaterialLaw law;
    bool isRing; ///< a quarter of a thick ring (rational), or a distorted box
};

inline std::ostream& operator<<(std::ostream& stream, const SolidKind& kind) {
    return stream << (kind.strains == Strains::linear ? "linear" : "nonlinear")
                  << (kind.law == MaterialLaw::neoHookean ? ", neo-Hookean" : ", St. Venant")
                  << (kind.isRing ? ", ring" : ", box");
}

inline std::vector<SolidKind> solidKinds() {
    std::vector<SolidKind> kinds;
    for (const bool isRing : {false, true}) {
        kinds.push_back({Strains::linear, MaterialLaw::stVenantKirchhoff, isRing});
        kinds.push_back({Strains::nonlinear, MaterialLaw::stVenantKirchhoff, isRing});
        kinds.push_back({Strains::nonlinear, MaterialLaw::neoHookean, isRing});
    }
    return kinds;
}

/// A box of 2 x 1 x 1 m, its inner control points moved so that all elements are
/// distorted.
inline geometry::NurbsVolume distortedBox(int degree) {
    const geometry::NurbsVolume fine = geometry::refine(geometry::block({0, 0, 0}, {2, 1, 1}),
                                                        {degree, degree, degree}, {2, 2, 2});
    geometry::Points points = fine.controlPoints();
    const geometry::Point upper(2, 1, 1);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        const auto x = points.row(k).array();
        if ((x > 1e-9).all() && (x < upper.transpose().array() - 1e-9).all()) {
            points.row(k) +=
                0.06 * Eigen::RowVector3d(std::sin(3.0 * k), std::cos(2.0 * k), std::sin(5.0 * k));
        }
    }
    return {fine.u(), fine.v(), fine.w(), points, fine.weights()};
}

/// Held at its bottom (eta = 0).
inline SolidDescription exampleVolume(const SolidKind& kind) {
    ElasticMaterial material;
    material.youngsModulus = 4e6;
    material.poissonsRatio = 0.3;
    material.density = 3000;
    material.law = kind.law;
    const geometry::NurbsVolume ring = geometry::refine(
        geometry::thickened(geometry::cylinderPatch({0, 0, 0}, 0.65, 0.4, 0, 0.5 * M_PI), 0.3),
        {2, 2, 2}, {2, 2, 1});
    return {kind.isRing ? ring : distortedBox(2),
            material,
            kind.strains,
            {{{geometry::Side::bottom}, {true, true, true}}},
            {}};
}

/// Displacement of all control points by a linear map X -> A X, which the functions
/// reproduce.
inline Eigen::VectorXd linearMotion(const Solid& solid, const Eigen::Matrix3d& A) {
    Eigen::VectorXd displacement(solid.nUnknowns());
    for (int k = 0; k < solid.volume().nControlPoints(); ++k) {
        const Eigen::Vector3d X = solid.volume().controlPoints().row(k);
        displacement.segment<3>(3 * k) = A * X - X;
    }
    return displacement;
}

inline Eigen::VectorXd solveStatic(Solid& solid, int nSteps = 1) {
    TimeIntegrator integrator(solid, TimeScheme::quasiStatic(), {}, 0);
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(static_cast<double>(step) / nSteps, 1.0 / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    return integrator.state().displacement;
}

} // namespace tokay::structure
