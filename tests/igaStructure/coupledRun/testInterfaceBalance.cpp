// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/ScriptedFluid.hpp"
#include "igaStructure/coupledRun/interfaceBalance.hpp"
#include "igaStructure/kinematics/beam/BeamBody.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/kinematics/plane/PlaneBody.hpp"
#include "igaStructure/kinematics/solid/exampleSolid.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <memory>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Points;

namespace {

std::unique_ptr<Body> beam(Strains strains) {
    ExampleBeam kind;
    kind.strains = strains;
    return std::make_unique<BeamBody>(
        Beam(geometry::refine(geometry::line({0, 0, 0}, {0, 1, 0}), 3, 8), kind.section(), strains,
             {}, {}));
}

// A thick flap whose depth is not 1, so that forces per unit depth are seen.
std::unique_ptr<Body> solid() {
    return std::make_unique<PlaneBody>(
        PlaneSolid(geometry::refine(geometry::rectangle({-0.05, 0, 0}, 0.1, 1), 2, 3, 2, 6),
                   exampleMaterial(Kinematics::planeStress), Strains::nonlinear, {}, {}));
}

// The wet edges of the plane solid; a beam is wet all over.
Coupling wetPart(const Body& body) {
    Coupling coupling;
    const bool isBeam = dynamic_cast<const BeamBody*>(&body) != nullptr;
    coupling.method = isBeam ? TransferMethod::offset : TransferMethod::nearestElement;
    coupling.interface = {"left", "top", "right"};
    coupling.gapLimit = 0.1;
    return coupling;
}

VectorXd randomVector(Eigen::Index size, double amplitude, unsigned seed) {
    std::srand(seed);
    return amplitude * VectorXd::Random(size);
}

// What the fluid has: forces at the means of the moved points of each face.
channel::InterfaceBalance fluidBalance(const WetBoundary& boundary, const AuditedStep& step) {
    const Points before = boundary.points() + boundary.transfer().displacements(step.before);
    const Points after = boundary.points() + boundary.transfer().displacements(step.after);
    const Points centres = boundary.faces().means(after);
    const Points motion = boundary.faces().means(after - before);
    channel::InterfaceBalance balance;
    for (int face = 0; face < boundary.nFaces(); ++face) {
        const Vector3d force(step.forces[2 * face], step.forces[2 * face + 1], 0);
        const Vector3d moment = Vector3d(centres.row(face)).cross(force);
        for (int c = 0; c < 3; ++c) {
            balance.force[c] += force[c];
            balance.moment[c] += moment[c];
        }
        balance.power += force.dot(Vector3d(motion.row(face))) / step.deltaT;
    }
    return balance;
}

void expectSameForceAndMoment(const channel::InterfaceBalance& a,
                              const channel::InterfaceBalance& b, double scale) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(a.force[c], b.force[c], 1e-10 * scale);
        EXPECT_NEAR(a.moment[c], b.moment[c], 1e-10 * scale);
    }
}

channel::Interface cube() {
    channel::Interface fluid;
    fluid.dimension = 3;
    for (int i = 0; i < 8; ++i) {
        fluid.points.insert(fluid.points.end(), {i % 2 - 0.5, i / 2 % 2 - 0.5, i / 4 - 0.5});
    }
    fluid.facePoints = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    fluid.faceOffsets = {0, 4, 8, 12, 16, 20, 24};
    return fluid;
}

Points cubePoints() {
    const channel::Interface fluid = cube();
    return Eigen::Map<const Eigen::Matrix<double, 8, 3, Eigen::RowMajor>>(fluid.points.data());
}

} // namespace

TEST(InterfaceFaces, cube_that_grows_about_its_centre_sweeps_the_difference_of_the_volumes) {
    const InterfaceFaces faces(cube());
    // Normals out of the cube: from 1 to 8 m^3
    EXPECT_NEAR(faces.sweptVolume(cubePoints(), 2 * cubePoints()), 7, 1e-14 * 8);
}

TEST(InterfaceFaces, cube_that_moves_and_turns_sweeps_nothing_in_all) {
    const InterfaceFaces faces(cube());
    Points moved = cubePoints() * Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()).matrix();
    moved.rowwise() += Eigen::RowVector3d(0.3, -0.2, 0.5);
    // Points that go straight do not keep the shape on the way, but end with the same volume
    EXPECT_NEAR(faces.sweptVolume(cubePoints(), moved), 0, 1e-14);
}

TEST(InterfaceFaces, forces_on_points_do_the_work_of_the_faces) {
    const InterfaceFaces faces(cube());
    const Points forces = Points::Random(6, 3), motion = Points::Random(8, 3);
    EXPECT_NEAR(faces.onPoints(forces).cwiseProduct(motion).sum(),
                forces.cwiseProduct(faces.means(motion)).sum(), 1e-14);
}

TEST(InterfaceBalance, force_and_moment_are_the_fluids_in_any_state) {
    for (const auto& body : {beam(Strains::nonlinear), solid()}) {
        const WetBoundary boundary(*body, wetPart(*body), flapInterface(20));
        const int n = body->model().nUnknowns();
        const VectorXd d = randomVector(n, 0.05, 1);
        const VectorXd forces = randomVector(2 * boundary.nFaces(), 1, 2);
        const AuditedStep step{forces, VectorXd::Zero(n), d, d, 0.1};
        expectSameForceAndMoment(interfaceBalance(boundary, step), fluidBalance(boundary, step),
                                 boundary.nFaces());
    }
}

TEST(InterfaceBalance, power_is_the_fluids_where_points_move_linearly_with_the_unknowns) {
    for (const auto& body : {beam(Strains::linear), solid()}) {
        const WetBoundary boundary(*body, wetPart(*body), flapInterface(20));
        const int n = body->model().nUnknowns();
        const VectorXd forces = randomVector(2 * boundary.nFaces(), 1, 3);
        const VectorXd before = randomVector(n, 0.05, 4), after = randomVector(n, 0.05, 5);
        const AuditedStep step{forces, before, before, after, 0.1};
        const double fluid = fluidBalance(boundary, step).power;
        EXPECT_NEAR(interfaceBalance(boundary, step).power, fluid, 1e-12 * boundary.nFaces());
    }
}

TEST(InterfaceBalance, translation_under_a_uniform_pressure_has_the_known_power_and_volume) {
    const auto body = solid();
    const channel::Interface fluid = flapInterface(10);
    const WetBoundary boundary(*body, wetPart(*body), fluid);
    // The flap's foot is dry: a pressure p presses down, p x 0.1 m
    const double p = 50;
    VectorXd forces(2 * boundary.nFaces());
    for (int face = 0; face < boundary.nFaces(); ++face) {
        const std::uint32_t a = fluid.facePoints[2 * face], b = fluid.facePoints[2 * face + 1];
        forces[2 * face] = p * (fluid.points[2 * b + 1] - fluid.points[2 * a + 1]);
        forces[2 * face + 1] = -p * (fluid.points[2 * b] - fluid.points[2 * a]);
    }
    const int n = body->model().nUnknowns();
    VectorXd translation(n);
    for (int k = 0; k < n / 2; ++k) {
        translation.segment<2>(2 * k) << 0.03, -0.2;
    }
    const VectorXd rest = VectorXd::Zero(n);
    const auto balance = interfaceBalance(boundary, {forces, rest, rest, translation, 0.5});
    EXPECT_NEAR(balance.force[0], 0, 1e-12 * p);
    EXPECT_NEAR(balance.force[1], -0.1 * p, 1e-12 * p);
    EXPECT_NEAR(balance.moment[2], -0.1 * p * 0.03, 1e-12 * p); // about the origin
    EXPECT_NEAR(balance.power, 0.1 * p * 0.2 / 0.5, 1e-12 * p);
    EXPECT_NEAR(balance.sweptVolume, 0.1 * 0.2, 1e-14);
}
