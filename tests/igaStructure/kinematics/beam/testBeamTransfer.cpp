// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleBeam.hpp"
#include "exampleBeamCase.hpp"
#include "igaStructure/ScriptedFluid.hpp"
#include "igaStructure/coupledRun/WetBoundary.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/beam/BeamBody.hpp"
#include "igaStructure/kinematics/facesAtPoints.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;
using testing::HasSubstr;

namespace {

const std::string noLoads = "loads:\n  - {traction: [\"100*y\", 0]}\n";

std::string coupledBeam(const std::string& strains) {
    std::string text = exampleBeamText(noLoads, "");
    text.replace(text.find("nonlinear"), 9, strains);
    return text + "coupling: {}\n";
}

BeamBody flap(Strains strains) {
    ExampleBeam kind;
    kind.strains = strains;
    return BeamBody(Beam(geometry::refine(geometry::line({0, 0, 0}, {0, 1, 0}), 3, 8),
                         kind.section(), strains, {{BeamEnd::start, true, true, true}}, {}));
}

VectorXd randomVector(Eigen::Index size, double amplitude, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    VectorXd vector(size);
    for (double& value : vector) {
        value = uniform(generator);
    }
    return vector;
}

// Centres of the fluid's faces around the flap.
geometry::Points centresOf(const channel::Interface& fluid) {
    geometry::Points centres =
        geometry::Points::Zero(static_cast<Eigen::Index>(fluid.faceOffsets.size()) - 1, 3);
    for (Eigen::Index face = 0; face < centres.rows(); ++face) {
        for (int end = 0; end < 2; ++end) {
            const std::uint32_t point = fluid.facePoints[fluid.faceOffsets[face] + end];
            for (int c = 0; c < 2; ++c) {
                centres(face, c) += 0.5 * fluid.points[2 * point + c];
            }
        }
    }
    return centres;
}

Coupling offsetCoupling(LoadTransfer loads = LoadTransfer::transposed) {
    Coupling coupling;
    coupling.loads = loads;
    coupling.method = TransferMethod::offset;
    coupling.gapLimit = 0.1;
    return coupling;
}

} // namespace

TEST(BeamTransfer, forces_and_motion_of_face_centres_do_the_same_virtual_work_at_any_state) {
    for (Strains strains : {Strains::linear, Strains::nonlinear}) {
        const BeamBody body = flap(strains);
        const geometry::Points centres = centresOf(flapInterface(20));
        const auto transfer = body.transfer(offsetCoupling(), facesAtPoints(centres));
        const int n = body.model().nUnknowns();
        const VectorXd d = randomVector(n, 0.05, 1);
        const VectorXd variation = randomVector(n, 1, 2);
        geometry::Points forces = geometry::Points::Zero(centres.rows(), 3);
        forces.leftCols(2) =
            randomVector(2 * static_cast<int>(centres.rows()), 1, 3).reshaped(centres.rows(), 2);
        const double h = 1e-5; // central difference: errors below 1e-8
        const geometry::Points motion = (transfer->displacements(d + h * variation) -
                                         transfer->displacements(d - h * variation)) /
                                        (2 * h);
        const double work = motion.cwiseProduct(forces).sum();
        EXPECT_NEAR(transfer->forces(d, forces).dot(variation), work,
                    1e-7 * forces.norm() * motion.norm());
    }
}

TEST(BeamTransfer, couple_of_opposite_forces_on_both_sides_arrives_as_a_moment) {
    const BeamBody body = flap(Strains::nonlinear);
    const channel::Interface fluid = flapInterface(20);
    const WetBoundary boundary(body, offsetCoupling(), fluid);
    // Down on the left, up on the right: turns the upward axis to the left.
    VectorXd values = VectorXd::Zero(2 * boundary.nFaces());
    values[2 * 10 + 1] = -1;
    values[2 * (boundary.nFaces() - 11) + 1] = 1;
    const VectorXd d = VectorXd::Zero(body.model().nUnknowns());
    const VectorXd force = boundary.forces(values, d);
    // A small rotation about the foot as variation: work = moment = 2 x 0.05.
    const auto& line = static_cast<const Beam&>(body.model());
    VectorXd rotation(d.size());
    for (int k = 0; k < line.curve().nControlPoints(); ++k) {
        rotation.segment<2>(2 * k) =
            turned(line.curve().controlPoints().row(k).head<2>().transpose());
    }
    // The unknown of the held rotation is relative to the foot.
    rotation[3] = 0;
    rotation[2] = 0;
    EXPECT_NEAR(force.dot(rotation), 0.1, 1e-12);
}

TEST(BeamTransfer, sides_keep_their_distance_in_a_large_rotation) {
    const BeamBody body = flap(Strains::nonlinear);
    const channel::Interface fluid = flapInterface(20);
    const WetBoundary boundary(body, offsetCoupling(), fluid);
    VectorXd d = randomVector(body.model().nUnknowns(), 0.05, 5);
    const VectorXd u = boundary.displacements(d);
    const int n = boundary.nPoints();
    for (int i = 0; i < n / 2; ++i) { // points at the same height, on the left and the right
        const int j = n - 1 - i;
        const double dx = 0.1 + u[2 * j] - u[2 * i];
        const double dy = u[2 * j + 1] - u[2 * i + 1];
        EXPECT_NEAR(std::hypot(dx, dy), 0.1, 1e-13);
    }
}

TEST(BeamTransfer, coupled_beam_moves_under_a_constant_force_as_under_a_traction_alone) {
    const TemporaryDirectory coupled;
    const channel::Interface fluid = flapInterface(400);
    ScriptedFluid script(coupled.write("case.yaml", coupledBeam("linear")));
    const std::string report = script.start(fluid);
    EXPECT_THAT(report, HasSubstr("coupling: interface the whole body, displacements offset, loads "
                                  "integrated, gap limit 0.1"));
    EXPECT_THAT(report, HasSubstr("offset points of a beam"));
    for (std::uint32_t step = 1; step <= 10; ++step) {
        script.advance(step, 0.01, forceOnLeft(fluid, 100));
    }
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    const auto rows = tableRows(coupled.read("postProcessing/case/0/watchPoints.dat"));
    ASSERT_EQ(rows.size(), 10u);

    // The fluid's force counts as zero at the start, so must the traction.
    std::string text = exampleBeamText("\"100*y\"", "\"t > 0 ? 100 : 0\"");
    text.replace(text.find("nonlinear"), 9, "linear");
    const Case alone = readText(text);
    auto line = std::get<BeamDescription>(alone.structure);
    Beam model(line.curve, line.section, line.strains, line.supports, line.loads);
    TimeIntegrator integrator(model, *alone.implicitScheme(), alone.newton, 0);
    for (int step = 1; step <= 10; ++step) {
        integrator.beginTimeStep(0.01 * step, 0.01);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    const double tip = endDisplacement(model, integrator.state().displacement)[0];
    // Face centres sample the constant traction: error (1/400)^2.
    EXPECT_NEAR(rows.back()[1], tip, 1e-5 * std::abs(tip));
}

TEST(BeamTransfer, nonlinear_coupled_beam_needs_few_exchanges_and_repeats_its_answer) {
    const TemporaryDirectory directory;
    const channel::Interface fluid = flapInterface(20);
    ScriptedFluid script(directory.write("case.yaml", coupledBeam("nonlinear")));
    script.start(fluid);
    const std::vector<double> values = forceOnLeft(fluid, 2000);
    script.begin(1, 0.01, 0.01);
    std::vector<channel::Displacements> answers;
    for (int k = 0; k < 4; ++k) {
        answers.push_back(script.exchange(values));
    }
    const auto accepted = script.exchange(values, true);
    // The sections at which forces act settle with the displacements.
    for (std::size_t k = 0; k < accepted.values.size(); ++k) {
        EXPECT_NEAR(accepted.values[k], answers.back().values[k], 1e-8);
    }
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
}

TEST(BeamTransfer, fluid_farther_away_than_the_gap_limit_is_refused) {
    const TemporaryDirectory directory;
    std::string text = coupledBeam("linear");
    text.replace(text.find("coupling: {}"), 12, "coupling: {mapping: {gapLimit: 0.01}}");
    ScriptedFluid script(directory.write("case.yaml", text));
    script.channel().send(flapInterface(20));
    EXPECT_THAT(script.failureText(), HasSubstr("0.05"));
}
