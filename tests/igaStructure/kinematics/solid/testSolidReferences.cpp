// SPDX-License-Identifier: GPL-3.0-or-later
// Solids against exact solutions and against other kinematics.
#include "exampleVolume.hpp"
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Side;

namespace {

ElasticMaterial elastic(double poissonsRatio) {
    ElasticMaterial material;
    material.youngsModulus = 4e6;
    material.poissonsRatio = poissonsRatio;
    material.density = 3000;
    return material;
}

VectorField along(const Vector3d& value) {
    return VectorField::constant(value);
}

// The strip of PlaneSolid's tests, 1 m deep, which does not move along z.
Solid deepStrip(Strains strains, SolidLoads loads) {
    const auto strip =
        geometry::refine(geometry::block({0, 0, 0}, {0.1, 1, 1}), {2, 3, 1}, {2, 4, 1});
    return Solid({strip,
                  elastic(0.3),
                  strains,
                  {{{Side::bottom}, {true, true, true}},
                   {{Side::back}, {false, false, true}},
                   {{Side::front}, {false, false, true}}},
                  std::move(loads)});
}

PlaneSolid planeStrip(Strains strains, Loads loads) {
    PlaneMaterial material;
    material.youngsModulus = 4e6;
    material.poissonsRatio = 0.3;
    material.density = 3000;
    return {geometry::refine(geometry::rectangle({0, 0, 0}, 0.1, 1), 2, 3, 2, 4),
            material,
            strains,
            {{geometry::Edge::bottom, {true, true}}},
            std::move(loads)};
}

// Displacement of the plane strip in both layers of the deep one.
VectorXd inBothLayers(const VectorXd& plane) {
    const Eigen::Index n = plane.size() / 2;
    VectorXd deep = VectorXd::Zero(6 * n);
    for (Eigen::Index k = 0; k < n; ++k) {
        deep.segment<2>(3 * k) = deep.segment<2>(3 * (n + k)) = plane.segment<2>(2 * k);
    }
    return deep;
}

} // namespace

TEST(SolidReferences, slab_held_along_z_has_the_forces_and_stress_of_plane_strain) {
    for (const Strains strains : {Strains::linear, Strains::nonlinear}) {
        const PlaneSolid plane = planeStrip(strains, {});
        const Solid deep = deepStrip(strains, {});
        const VectorXd d = randomMotion(plane.nUnknowns(), 0.005);
        const VectorXd expected = plane.internalForce(d).force;
        const VectorXd force = deep.internalForce(inBothLayers(d)).force;
        const Eigen::Index n = d.size() / 2;
        VectorXd sum(d.size());
        for (Eigen::Index k = 0; k < n; ++k) {
            sum.segment<2>(2 * k) = force.segment<2>(3 * k) + force.segment<2>(3 * (n + k));
        }
        EXPECT_LT((sum - expected).norm(), 1e-13 * expected.norm()); // rounding
        const Eigen::Matrix3d stress = deep.stateAt({0.3, 0.6, 0.2}, inBothLayers(d)).cauchyStress;
        const Eigen::Matrix3d planeStress = plane.stateAt(0.3, 0.6, d).cauchyStress;
        EXPECT_LT((stress - planeStress).norm(), 1e-12 * planeStress.norm());
    }
}

TEST(SolidReferences, slab_held_along_z_bends_as_plane_strain_does) {
    SolidLoads loads;
    loads.tractions.push_back({Side::left, along({300, 0, 0})});
    Solid deep = deepStrip(Strains::nonlinear, loads);
    PlaneSolid plane =
        planeStrip(Strains::nonlinear,
                   {{{geometry::Edge::left, {Formula("300", "test"), Formula("0", "test")}}}, {}});
    const VectorXd displacement = solveStatic(deep);
    TimeIntegrator integrator(plane, TimeScheme::quasiStatic(), {}, 0);
    integrator.beginTimeStep(1, 1);
    integrator.solve();
    const VectorXd expected = inBothLayers(integrator.displacement());
    // Newton's method ends at a residual of 1e-8 or less, in its quadratic range.
    EXPECT_LT((displacement - expected).norm(), 1e-7 * expected.norm());
    EXPECT_GT(expected.lpNorm<Eigen::Infinity>(), 0.05); // it does bend
}

TEST(SolidReferences, distorted_elements_pulled_at_an_end_have_the_exact_linear_field) {
    // Degree + 1 points are exact while the elements are of degree 2 at most.
    const geometry::NurbsVolume boxes[] = {distortedBox(1), distortedBox(2),
                                           geometry::elevateDegree(distortedBox(2), {1, 1, 1})};
    for (const geometry::NurbsVolume& box : boxes) {
        const int degree = box.u().degree();
        SolidLoads loads;
        loads.tractions.push_back({Side::right, along({4000, 0, 0})});
        Solid solid({box,
                     elastic(0.3),
                     Strains::linear,
                     {{{Side::left}, {true, false, false}},
                      {{Side::bottom}, {false, true, false}},
                      {{Side::back}, {false, false, true}}},
                     loads});
        const VectorXd d = solveStatic(solid);
        const double strain = 4000 / 4e6;
        const Eigen::Matrix3d stretch =
            Vector3d(1 + strain, 1 - 0.3 * strain, 1 - 0.3 * strain).asDiagonal();
        const VectorXd expected = linearMotion(solid, stretch);
        EXPECT_LT((d - expected).norm(), 1e-11 * expected.norm()) << degree; // rounding, solver
        Eigen::Matrix3d stress = solid.stateAt({0.3, 0.6, 0.7}, d).cauchyStress;
        stress(0, 0) -= 4000;
        EXPECT_LT(stress.norm(), 1e-9 * 4000) << degree;
    }
}

TEST(SolidReferences, cantilever_bends_as_Timoshenkos_beam) {
    SolidLoads loads;
    const double traction = 1; // on 1 m^2
    loads.tractions.push_back({Side::right, along({0, traction, 0})});
    const auto beam =
        geometry::refine(geometry::block({0, 0, 0}, {10, 1, 1}), {3, 3, 2}, {10, 1, 1});
    Solid solid({beam, elastic(0), Strains::linear, {{{Side::left}, {true, true, true}}}, loads});
    const double tip = solid.stateAt({1, 0.5, 0.5}, solveStatic(solid)).displacement[1];
    const double E = 4e6;
    const double bending = traction * 1000 / (3 * E / 12);
    const double shear = traction * 10 / (5.0 / 6 * E / 2); // 0.6 % of the bending
    // The clamped root, where the section cannot warp, is left out of the formula.
    EXPECT_NEAR(tip, bending + shear, 5e-4 * bending);
}

TEST(SolidReferences, thick_cylinder_under_pressure_widens_as_Lame_says) {
    const double a = 0.5;
    const double b = 0.8;
    const double pressure = 1000;
    SolidLoads loads;
    loads.pressures.push_back({Side::back, ScalarField::constant(pressure)});
    const auto quarter = geometry::refine(
        geometry::thickened(geometry::cylinderPatch({0, 0, 0}, 0.65, 0.2, 0, 0.5 * M_PI), b - a),
        {3, 1, 3}, {3, 1, 4});
    Solid solid({quarter,
                 elastic(0.3),
                 Strains::linear,
                 {{{Side::left}, {false, true, false}},
                  {{Side::right}, {true, false, false}},
                  {{Side::bottom}, {false, false, true}},
                  {{Side::top}, {false, false, true}}},
                 loads});
    const VectorXd d = solveStatic(solid);
    const double factor = pressure * a * a / (b * b - a * a);
    for (const double s : {0.0, 0.5, 1.0}) {
        const double r = a + s * (b - a);
        const Eigen::Matrix3d stress = solid.stateAt({0, 0.5, s}, d).cauchyStress;
        const double widening = solid.stateAt({0, 0.5, s}, d).displacement[0];
        const double expected = 1.3 / 4e6 * factor * (0.4 * r + b * b / r);
        // Cubic elements, a quarter of the thickness long: error of order h^4 / 1000.
        EXPECT_NEAR(widening, expected, 1e-5 * expected) << r;
        EXPECT_NEAR(stress(1, 1), factor * (1 + b * b / (r * r)), 5e-3 * pressure) << r;
        EXPECT_NEAR(stress(0, 0), factor * (1 - b * b / (r * r)), 5e-3 * pressure) << r;
    }
}
