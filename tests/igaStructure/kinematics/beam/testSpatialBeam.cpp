// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "exampleBeam.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

namespace {

const std::vector<BeamSupport> clamped = {{BeamEnd::start, true, true, true, true}};

VectorXd randomVector(Eigen::Index size, double amplitude) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    VectorXd vector(size);
    for (double& value : vector) {
        value = uniform(generator);
    }
    return vector;
}

Matrix3d rotation(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

geometry::NurbsCurve rotated(const geometry::NurbsCurve& curve, const Matrix3d& R) {
    return {curve.knotVector(), curve.controlPoints() * R.transpose(), curve.weights()};
}

// A straight beam, or a curved prestressed cable, off all axes.
Beam beam(Strains strains, std::vector<BeamSupport> supports = clamped, BeamLoads loads = {}) {
    const ExampleBeam kind;
    return {rotated(kind.curve(), rotation(0.7)), kind.section(), strains, supports, loads, 3};
}

Beam cable(Strains strains, std::vector<BeamSupport> supports = clamped) {
    ExampleBeam kind;
    kind.arc = true;
    BeamSection section = kind.section();
    section.bendingStiffness = 0;
    section.prestress = 300;
    return {rotated(kind.curve(), rotation(0.7)), section, strains, supports, {}, 3};
}

// Control displacements x -> R x - X + shift, x being the displaced positions.
VectorXd moved(const Beam& line, const VectorXd& displacement, const Matrix3d& R) {
    VectorXd result = displacement;
    for (int k = 0; k < line.curve().nControlPoints(); ++k) {
        const Vector3d X = line.curve().controlPoints().row(k);
        result.segment<3>(3 * k) =
            R * (X + displacement.segment<3>(3 * k)) - X + Vector3d(3, -2, 1);
    }
    return result;
}

// Of a plane line's control displacements.
VectorXd inSpace(const VectorXd& plane, const Matrix3d& R) {
    VectorXd result(plane.size() / 2 * 3);
    for (Eigen::Index k = 0; k < plane.size() / 2; ++k) {
        result.segment<3>(3 * k) = R.leftCols<2>() * plane.segment<2>(2 * k);
    }
    return result;
}

EndLoad spatialForce(const Vector3d& force, const std::string& time = "*t") {
    std::vector<Formula> components;
    for (double component : force) {
        components.emplace_back(fmt::format("({:.17g}){}", component, time), "");
    }
    return {BeamEnd::end, components, std::nullopt};
}

std::vector<Beam> kinds(std::vector<BeamSupport> supports) {
    std::vector<Beam> kinds;
    for (Strains strains : {Strains::linear, Strains::nonlinear}) {
        kinds.push_back(beam(strains, supports));
        kinds.push_back(cable(strains, supports));
    }
    return kinds;
}

} // namespace

TEST(SpatialBeam, tangent_equals_finite_differences) {
    std::vector<BeamSupport> supports = clamped;
    supports.push_back({BeamEnd::end, false, true, true, false});
    for (const Beam& line : kinds(supports)) {
        const VectorXd d = randomVector(line.nUnknowns(), 0.3);
        SparseMatrix tangent;
        line.internalForce(d, tangent);
        MatrixXd numeric(d.size(), d.size());
        const double h = 1e-5;
        for (Eigen::Index k = 0; k < d.size(); ++k) {
            const VectorXd shift = h * VectorXd::Unit(d.size(), k);
            numeric.col(k) =
                (line.internalForce(d + shift).force - line.internalForce(d - shift).force) /
                (2 * h);
        }
        // Truncation and rounding errors of central differences are below 1e-8 here.
        EXPECT_LT((MatrixXd(tangent) - numeric).norm(), 1e-7 * numeric.norm());
    }
}

TEST(SpatialBeam, internal_force_is_the_derivative_of_strain_energy) {
    for (const Beam& line : kinds(clamped)) {
        const VectorXd d = randomVector(line.nUnknowns(), 0.3);
        const VectorXd direction = randomVector(line.nUnknowns(), 1).reverse();
        const double h = 1e-5;
        const double difference =
            (line.strainEnergy(d + h * direction) - line.strainEnergy(d - h * direction)) / (2 * h);
        const double derivative = line.internalForce(d).force.dot(direction);
        EXPECT_NEAR(difference, derivative, 1e-7 * std::abs(derivative));
    }
}

TEST(SpatialBeam, rigid_motion_of_a_deformed_line_turns_its_forces_and_keeps_its_energy) {
    for (const Beam& line : {beam(Strains::nonlinear, {}), cable(Strains::nonlinear, {})}) {
        const VectorXd d = randomVector(line.nUnknowns(), 0.3);
        const VectorXd force = line.internalForce(d).force;
        for (double angle : {0.1, 1.5, M_PI, 7.0}) {
            const Matrix3d R = rotation(angle);
            const VectorXd turned = line.internalForce(moved(line, d, R)).force;
            double error = 0;
            for (Eigen::Index k = 0; k < force.size(); k += 3) {
                error += (turned.segment<3>(k) - R * force.segment<3>(k)).norm();
            }
            EXPECT_LT(error, 1e-10 * force.norm()) << angle; // rounding of 20 m in elements of 1 m
            EXPECT_NEAR(line.strainEnergy(moved(line, d, R)), line.strainEnergy(d),
                        1e-11 * line.strainEnergy(d));
        }
    }
}

TEST(SpatialBeam, rigid_motion_gives_no_force_at_any_angle) {
    const Beam line = beam(Strains::nonlinear, {});
    const VectorXd rest = VectorXd::Zero(line.nUnknowns());
    for (double angle : {0.1, 1.0, 0.5 * M_PI, 3.0, M_PI, 7.0, 100.0}) {
        const VectorXd force = line.internalForce(moved(line, rest, rotation(angle))).force;
        EXPECT_LT(force.norm(), 1e-12 * line.section().axialStiffness); // rounding, as in the plane
    }
}

TEST(SpatialBeam, small_rigid_rotation_gives_no_force_if_strains_are_linear) {
    const Beam line = beam(Strains::linear, {});
    VectorXd d(line.nUnknowns());
    for (int k = 0; k < line.curve().nControlPoints(); ++k) {
        const Vector3d X = line.curve().controlPoints().row(k);
        d.segment<3>(3 * k) = Vector3d(0.3, 1, -2).cross(X);
    }
    EXPECT_LT(line.internalForce(d).force.norm(), 1e-11 * line.section().axialStiffness * 20);
}

TEST(SpatialBeam, motion_in_an_oblique_plane_has_the_forces_and_mass_of_the_plane_line) {
    for (Strains strains : {Strains::linear, Strains::nonlinear}) {
        ExampleBeam kind;
        kind.strains = strains;
        kind.supports = {};
        kind.rotaryInertia = true;
        const Beam plane = kind.build();
        const Matrix3d R = rotation(0.7);
        const Beam space(rotated(kind.curve(), R), kind.section(), strains, {}, {}, 3);
        const VectorXd d = randomVector(plane.nUnknowns(), 0.3);
        const VectorXd force = inSpace(plane.internalForce(d).force, R);
        EXPECT_LT((space.internalForce(inSpace(d, R)).force - force).norm(), 1e-11 * force.norm());
        const VectorXd inertia = inSpace(plane.massMatrix() * d, R);
        EXPECT_LT((space.massMatrix() * inSpace(d, R) - inertia).norm(), 1e-12 * inertia.norm());
        EXPECT_NEAR(space.stateAt(0.3, inSpace(d, R)).bendingMoment,
                    std::abs(plane.stateAt(0.3, d).bendingMoment), 1e-8);
        EXPECT_NEAR(space.stateAt(0.3, inSpace(d, R)).shearForce,
                    std::abs(plane.stateAt(0.3, d).shearForce), 1e-6);
    }
}

TEST(SpatialBeam, elastica_in_an_oblique_plane_is_the_plane_one) {
    ExampleBeam kind;
    kind.loads.ends.push_back(endForce("0", "4*t"));
    Beam plane = kind.build();
    const VectorXd exact =
        inSpace(plane.controlDisplacements(loadSteps(plane, 20).back()), rotation(0.7));
    BeamLoads loads;
    loads.ends.push_back(spatialForce(rotation(0.7) * Vector3d(0, 4, 0)));
    Beam space = beam(Strains::nonlinear, clamped, loads);
    const VectorXd d = space.controlDisplacements(loadSteps(space, 20).back());
    EXPECT_LT((d - exact).norm(), 1e-8 * exact.norm()); // Newton's tolerance is 1e-10
    // Sze, Liu & Lo 2004: deflection 6.698 under the whole load.
    EXPECT_NEAR((rotation(0.7).transpose() * d.tail<3>())[1], 6.698, 0.005 * 6.698);
}

TEST(SpatialBeam, linear_cantilever_bends_in_two_planes_at_once) {
    const Vector3d force(0, 0.3, -0.5);
    BeamLoads loads;
    loads.ends.push_back(spatialForce(rotation(0.7) * force));
    Beam line = beam(Strains::linear, clamped, loads);
    const VectorXd d = loadSteps(line, 1).back();
    const Vector3d tip = rotation(0.7).transpose() * line.controlDisplacements(d).tail<3>();
    const double flexibility = 1000 / (3 * line.section().bendingStiffness); // L^3 / 3 E I
    // Exact at degree 3 or more but for rounding: the axial stiffness is 1e6 times larger.
    EXPECT_LT((tip - flexibility * force).norm(), 1e-7 * tip.norm());
    EXPECT_NEAR(line.stateAt(0.25, d).bendingMoment, 7.5 * force.norm(), 1e-5);
    EXPECT_NEAR(line.stateAt(0.25, d).shearForce, force.norm(), 1e-5);
}

TEST(SpatialBeam, frequencies_of_a_cantilever_come_in_pairs) {
    const Beam line = beam(Strains::linear);
    const NaturalModes modes = naturalModes(line, 6);
    const double roots[] = {1.875104069, 4.694091133, 7.854757438};
    for (int k = 0; k < 6; ++k) {
        const double exact = std::pow(roots[k / 2] / 10, 2) *
                             std::sqrt(line.section().bendingStiffness / line.section().mass);
        EXPECT_NEAR(modes.angularFrequencies[k], exact, 1e-4 * exact); // degree 4, 8 elements
    }
}

TEST(SpatialBeam, held_rotation_is_exact_however_far_the_end_moves) {
    BeamLoads loads;
    loads.ends.push_back(spatialForce({-3, 2, 4}));
    std::vector<BeamSupport> supports = clamped;
    supports.push_back({BeamEnd::end, false, false, true}); // keeps its direction, moves freely
    Beam line = beam(Strains::nonlinear, supports, loads);
    const VectorXd d = line.controlDisplacements(loadSteps(line, 10).back());
    EXPECT_GT(d.tail<3>().norm(), 1);
    const Vector3d axis = rotation(0.7).col(0);
    const int n = line.curve().nControlPoints();
    for (int k : {1, n - 1}) { // the first two, and the last two
        const Vector3d between = d.segment<3>(3 * k) - d.segment<3>(3 * k - 3);
        EXPECT_LT(axis.cross(between).norm(), 1e-12);
    }
}

TEST(SpatialBeam, free_rigid_motions_are_named) {
    EXPECT_TRUE(beam(Strains::linear).freeRigidMotions().empty());
    const BeamSupport start{BeamEnd::start, true, true, false, true};
    // About two axes across the beam, which lies oblique.
    const auto aboutStart = testing::AllOf(testing::StartsWith("rotation about ("),
                                           testing::EndsWith("through (0, 0, 0)"));
    EXPECT_THAT(beam(Strains::linear, {start}).freeRigidMotions(),
                testing::ElementsAre(aboutStart, aboutStart));
    const BeamSupport end{BeamEnd::end, true, true, false, true};
    EXPECT_TRUE(beam(Strains::linear, {start, end}).freeRigidMotions().empty());
    // Held at both ends it swings about its chord, to which loads make it stiff.
    EXPECT_TRUE(cable(Strains::linear, {start, end}).freeRigidMotions().empty());
    const BeamSupport slider{BeamEnd::start, true, true, true, false};
    EXPECT_EQ(beam(Strains::linear, {slider}).freeRigidMotions(),
              std::vector<std::string>{"translation along z"});
}

TEST(SpatialBeam, curved_beam_is_refused) {
    ExampleBeam kind;
    kind.arc = true;
    try {
        Beam(kind.curve(), kind.section(), Strains::linear, {}, {}, 3);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a beam in space must be straight"));
    }
}
