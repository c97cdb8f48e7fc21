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
Coupling wetPart(const Body& body, LoadTransfer loads = LoadTransfer::transposed) {
    Coupling coupling;
    coupling.loads = loads;
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

TEST(InterfaceFaces, face_with_a_hanging_node_moves_with_its_centroid) {
    channel::Interface fluid = cube();
    // The middle of one side as a fifth point of the first face
    fluid.points.insert(fluid.points.end(), {-0.5, 0, -0.5});
    fluid.facePoints.insert(fluid.facePoints.begin() + 1, 8);
    for (std::size_t k = 1; k < fluid.faceOffsets.size(); ++k) {
        ++fluid.faceOffsets[k];
    }
    const InterfaceFaces faces(fluid);
    EXPECT_LT((faces.means(faces.mesh().vertices).row(0) - Eigen::RowVector3d(0, 0, -0.5)).norm(),
              1e-15);
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

TEST(InterfaceBalance, integrated_loads_keep_force_always_and_moment_to_second_order_of_the_faces) {
    for (const auto& body : {beam(Strains::nonlinear), solid()}) {
        const int n = body->model().nUnknowns();
        const auto difference = [&](int nFaces, const VectorXd& mapped) {
            const WetBoundary boundary(*body, wetPart(*body, LoadTransfer::integrated),
                                       flapInterface(nFaces));
            VectorXd forces = VectorXd::Constant(2 * boundary.nFaces(), 1.0 / boundary.nFaces());
            forces.segment<2>(2 * nFaces).setZero(); // the top is one face in every mesh
            const AuditedStep step{forces, VectorXd::Zero(n), mapped, mapped, 0.1};
            const channel::InterfaceBalance a = interfaceBalance(boundary, step);
            const channel::InterfaceBalance b = fluidBalance(boundary, step);
            EXPECT_NEAR(a.force[0], b.force[0], 1e-12);
            EXPECT_NEAR(a.force[1], b.force[1], 1e-12);
            return std::abs(a.moment[2] - b.moment[2]);
        };
        EXPECT_LT(difference(10, VectorXd::Zero(n)), 1e-12);
        // Chords of the fluid's points differ from the bent surface by their sagitta.
        double coarse = 0, fine = 0; // sums, as the sagittas of one state may cancel
        for (unsigned seed = 1; seed <= 8; ++seed) {
            const VectorXd d = randomVector(n, 0.02, seed);
            coarse += difference(20, d);
            fine += difference(80, d);
        }
        EXPECT_LT(fine, coarse / 10); // 1/16 by second order
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
