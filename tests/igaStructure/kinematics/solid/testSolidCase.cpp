// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "exampleVolume.hpp"
#include "igaStructure/ScriptedFluid.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/facesAtPoints.hpp"
#include "igaStructure/kinematics/solid/SolidBody.hpp"
#include "igaStructure/output/volumeMesh.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Points;
using testing::AllOf;
using testing::HasSubstr;

namespace {

// A cantilever of 10 x 1 x 1 m without Poisson effect, sheared at its end.
std::string cantileverText(const std::string& from = "", const std::string& to = "") {
    std::string text = "geometry:\n"
                       "  block: {origin: [0, 0, 0], size: [10, 1, 1]}\n"
                       "discretisation: {degree: [3, 2, 2], elements: [6, 1, 1]}\n"
                       "model: {kinematics: solid, strains: linear}\n"
                       "material: {type: StVenantKirchhoff, youngsModulus: 4e6, "
                       "poissonsRatio: 0, density: 1000}\n"
                       "supports:\n"
                       "  - {faces: [left], fix: [x, y, z]}\n"
                       "loads:\n"
                       "  - {face: right, traction: [0, 1, 0]}\n"
                       "time: {scheme: static, step: 1, end: 1}\n"
                       "output:\n"
                       "  interval: 1\n"
                       "  fields: [displacement, stress, vonMisesStress, principalStress]\n"
                       "  watchPoints:\n"
                       "    - {name: tip, at: [10, 0.5, 0.5]}\n";
    const auto place = text.find(from);
    if (place == std::string::npos) {
        throw std::logic_error("the example has no '" + from + "'");
    }
    return text.replace(place, from.size(), to);
}

double tipAfterRun(const std::string& text) {
    const TemporaryDirectory directory;
    runAlone(readCase(directory.write("case.yaml", text)), [](const std::string&) {});
    return tableRows(directory.read("postProcessing/case/0/watchPoints.dat")).back()[2];
}

std::string messageOf(const std::string& text) {
    try {
        makeBody(readText(text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

const double expectedTip = 1000 / (3 * 4e6 / 12) + 10 / (5.0 / 6 * 2e6); // Timoshenko's beam

std::string ringText(const std::string& strains) {
    return "geometry:\n"
           "  cylinder: {base: [0, 0, 0], radius: 2, height: 3, angles: [0, 120]}\n"
           "discretisation: {degree: [2, 2, 2], elements: [2, 3, 1]}\n"
           "model: {kinematics: solid, strains: " +
           strains +
           ", thickness: 0.5}\n"
           "material: {type: neoHookean, youngsModulus: 4e6, poissonsRatio: 0.3, density: 1000}\n"
           "supports: []\n"
           "time: {step: 0.01, end: 1}\n";
}

// Points on the inner and the outer wall of the ring of the case above.
Points pointsOnWalls(int n) {
    Points points(2 * n, 3);
    for (int k = 0; k < 2 * n; ++k) {
        const double radius = k % 2 == 0 ? 1.75 : 2.25;
        const double angle = 0.05 + 2.0 * k / (2 * n);
        points.row(k) << radius * std::cos(angle), radius * std::sin(angle),
            0.1 + 2.8 * k / (2 * n);
    }
    return points;
}

Coupling wetWalls() {
    Coupling coupling;
    coupling.interface = {"back", "front"};
    coupling.loads = LoadTransfer::transposed;
    coupling.gapLimit = 0.01;
    return coupling;
}

} // namespace

TEST(SolidCase, cantilever_bends_and_leaves_its_fields) {
    const TemporaryDirectory directory;
    std::vector<std::string> log;
    runAlone(readCase(directory.write("case.yaml", cantileverText())),
             [&](const std::string& line) { log.push_back(line); });
    EXPECT_THAT(log[0], AllOf(HasSubstr("solid, linear strains, degree 3 x 2 x 2"),
                              HasSubstr("mass 1e+04 kg")));
    const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    EXPECT_NEAR(rows.back()[2], expectedTip, 2e-3 * expectedTip); // six elements, clamped root
    int nFiles = 0;
    for (const auto& entry : std::filesystem::directory_iterator(directory.file("results"))) {
        if (entry.path().extension() == ".vtu") {
            ++nFiles;
            const std::string file = directory.read("results/" + entry.path().filename().string());
            EXPECT_THAT(file, AllOf(HasSubstr("principalStress"), HasSubstr("vonMisesStress")));
        }
    }
    EXPECT_EQ(nFiles, 2);
}

TEST(SolidCase, the_same_body_can_be_given_by_its_middle_surface_or_its_control_points) {
    const double tip = tipAfterRun(cantileverText());
    std::string plate =
        cantileverText("block: {origin: [0, 0, 0], size: [10, 1, 1]}",
                       "plate: {origin: [0, 0, 0.5], edgeXi: [10, 0, 0], edgeEta: [0, 1, 0]}");
    plate.replace(plate.find("strains: linear"), 15, "strains: linear, thickness: 1");
    EXPECT_NEAR(tipAfterRun(plate), tip, 1e-10 * tip);
    const std::string volume = cantileverText(
        "block: {origin: [0, 0, 0], size: [10, 1, 1]}",
        "nurbs: {degree: [1, 1, 1], knotsXi: [0, 0, 1, 1], knotsEta: [0, 0, 1, 1], "
        "knotsZeta: [0, 0, 1, 1], controlPoints: [[0, 0, 0], [10, 0, 0], [0, 1, 0], [10, 1, 0], "
        "[0, 0, 1], [10, 0, 1], [0, 1, 1], [10, 1, 1]]}");
    EXPECT_NEAR(tipAfterRun(volume), tip, 1e-10 * tip);
}

TEST(SolidCase, an_edge_is_held_by_the_names_of_two_faces) {
    const std::unique_ptr<Body> body =
        makeBody(readText(cantileverText("faces: [left]", "faces: [left, bottom]")));
    EXPECT_THAT(body->model().freeRigidMotions(), testing::SizeIs(1));
    const auto& fixed = body->model().fixed();
    EXPECT_EQ(std::count(fixed.begin(), fixed.end(), true), 3 * 3); // three functions along z
}

TEST(SolidCase, check_names_what_is_free_and_advises) {
    const std::string dynamic =
        cantileverText("time: {scheme: static, step: 1, end: 1}", "time: {step: 0.01, end: 1}");
    EXPECT_THAT(checkCase(readText(dynamic)),
                AllOf(HasSubstr("slenderness"), HasSubstr("lowest natural periods"),
                      HasSubstr("degree 3 x 2 x 2, 6 x 1 x 1 elements")));
    std::string loose = dynamic;
    loose.replace(loose.find("fix: [x, y, z]"), 14, "fix: [x, y]");
    EXPECT_THAT(checkCase(readText(loose)), HasSubstr("do not prevent: translation along z"));
}

TEST(SolidCase, mistakes_are_told_with_their_place) {
    EXPECT_THAT(messageOf(cantileverText("faces: [left]", "edge: left")), HasSubstr("edge"));
    EXPECT_THAT(messageOf(cantileverText("face: right", "face: outside")),
                AllOf(HasSubstr("loads[0].face"),
                      HasSubstr("'outside' is not allowed; allowed: left, right")));
    EXPECT_THAT(
        messageOf(cantileverText("{face: right, traction: [0, 1, 0]}", "{traction: [0, 1, 0]}")),
        HasSubstr("entry 'face' is missing"));
    EXPECT_THAT(
        messageOf(cantileverText("traction: [0, 1, 0]", "traction: [0, 1, 0], pressure: 1")),
        HasSubstr("exactly one of: traction, pressure, gravity"));
    EXPECT_THAT(messageOf(cantileverText("[3, 2, 2]", "[3, 2]")), HasSubstr("degree"));
    EXPECT_THAT(messageOf(cantileverText("size: [10, 1, 1]", "size: [10, 1]")), HasSubstr("size"));
    EXPECT_THAT(messageOf(cantileverText("strains: linear", "strains: linear, thickness: 1")),
                HasSubstr("thickness"));
    EXPECT_THAT(messageOf(cantileverText("StVenantKirchhoff", "incompressibleNeoHookean")),
                HasSubstr("'incompressibleNeoHookean' is not allowed"));
    const std::string inverted = cantileverText(
        "block: {origin: [0, 0, 0], size: [10, 1, 1]}",
        "nurbs: {degree: [1, 1, 1], knotsXi: [0, 0, 1, 1], knotsEta: [0, 0, 1, 1], "
        "knotsZeta: [0, 0, 1, 1], controlPoints: [[0, 0, 0], [10, 0, 0], [0, 1, 0], [10, 1, 0], "
        "[0, 0, -1], [10, 0, -1], [0, 1, -1], [10, 1, -1]]}");
    EXPECT_THAT(messageOf(inverted), AllOf(HasSubstr("turned inside out near x = "),
                                           HasSubstr("element 1 of 6 along xi")));
    EXPECT_THAT(messageOf(cantileverText() + "coupling: {interface: [left, inside]}\n"),
                HasSubstr("'inside' is not allowed"));
    EXPECT_THAT(messageOf(cantileverText() + "coupling: {}\n"),
                HasSubstr("entry 'interface' is missing: Wet faces"));
    EXPECT_THAT(messageOf(exampleText() + "coupling: {interface: [left, back]}\n"),
                HasSubstr("back"));
}

TEST(SolidBody, watch_points_inside_and_on_the_rim_are_found) {
    const std::unique_ptr<Body> body = makeBody(readText(ringText("linear")));
    for (const double radius : {1.75, 1.9, 2.25}) {
        const Vector3d point(radius * std::cos(1.1), radius * std::sin(1.1), 1.3);
        const Body::Closest found = body->closest(point);
        EXPECT_LT(found.distance, 1e-10);
        EXPECT_LT((body->positions({found.location}).col(0) - point).norm(), 1e-10);
    }
    EXPECT_NEAR(body->closest({3 * std::cos(1.1), 3 * std::sin(1.1), 1.3}).distance, 0.75, 1e-10);
}

TEST(SolidTransfer, virtual_work_and_forces_are_kept) {
    const std::unique_ptr<Body> body = makeBody(readText(ringText("nonlinear")));
    const Points points = pointsOnWalls(20);
    const auto transfer = body->transfer(wetWalls(), facesAtPoints(points));
    const Eigen::Index n = body->model().nUnknowns();
    const VectorXd v = VectorXd::Random(n);
    const Points forces = Points::Random(points.rows(), 3);
    const double work = transfer->displacements(v).cwiseProduct(forces).sum();
    const VectorXd onNodes = transfer->forces(v, forces);
    EXPECT_NEAR(onNodes.dot(v), work, 1e-12 * forces.norm() * transfer->displacements(v).norm());
    const Eigen::Map<const Points> rows(onNodes.data(), n / 3, 3);
    EXPECT_LT((rows.colwise().sum() - forces.colwise().sum()).norm(), 1e-12 * forces.norm());
}

TEST(SolidTransfer, rigid_motions_are_exact) {
    const std::unique_ptr<Body> body = makeBody(readText(ringText("nonlinear")));
    const auto& solid = dynamic_cast<const Solid&>(body->model());
    const Points points = pointsOnWalls(20);
    const auto transfer = body->transfer(wetWalls(), facesAtPoints(points));
    const Eigen::Matrix3d Q =
        Eigen::AngleAxisd(2, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    const Points moved = transfer->displacements(linearMotion(solid, Q));
    // Projection ends at steps of 1e-12 of the size.
    EXPECT_LT((moved - (points * Q.transpose() - points)).norm(), 1e-10);
}

TEST(SolidTransfer, point_far_from_the_wet_faces_is_refused) {
    const std::unique_ptr<Body> body = makeBody(readText(ringText("linear")));
    Points points = pointsOnWalls(3);
    points(2, 0) += 1;
    EXPECT_THROW(body->transfer(wetWalls(), facesAtPoints(points)), InputError);
}

TEST(SolidCase, coupled_run_under_constant_forces_gives_the_motion_of_the_same_traction) {
    const std::string time = "time: {scheme: static, step: 1, end: 1}";
    const std::string dynamic = "time: {step: 0.05, end: 0.5}";
    const std::string alone = cantileverText(time, dynamic);
    std::string text = alone;
    const std::string load = "  - {face: right, traction: [0, 1, 0]}\n";
    text.replace(text.find("loads:\n" + load), 7 + load.size(), "");
    text += "coupling: {interface: [right]}\n";
    channel::Interface fluid;
    fluid.dimension = 3;
    fluid.name = "structure";
    const int n = 4; // faces along each side
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            fluid.points.insert(fluid.points.end(), {10.0, i / double(n), j / double(n)});
        }
    }
    fluid.faceOffsets.push_back(0);
    for (int face = 0; face < n * n; ++face) {
        const auto corner = static_cast<std::uint32_t>(face % n + (n + 1) * (face / n));
        fluid.facePoints.insert(fluid.facePoints.end(),
                                {corner, corner + 1, corner + n + 2, corner + n + 1});
        fluid.faceOffsets.push_back(static_cast<std::uint32_t>(fluid.facePoints.size()));
    }
    fluid.displacements.assign(fluid.points.size(), 0);
    fluid.tolerance = 1e-6;
    fluid.endTime = 0.5;
    std::vector<double> forces(3 * n * n, 0);
    for (int face = 0; face < n * n; ++face) {
        forces[3 * face + 1] = 1.0 / (n * n);
    }
    const TemporaryDirectory directory;
    ScriptedFluid script(directory.write("case.yaml", text));
    EXPECT_THAT(script.start(fluid), HasSubstr("25 points, 16 faces"));
    for (std::uint32_t step = 1; step <= 10; ++step) {
        script.advance(step, 0.05, forces);
    }
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    const TemporaryDirectory second;
    std::string tractions = alone;
    // The fluid's force counts as zero at the start, so must the traction.
    tractions.replace(tractions.find("[0, 1, 0]"), 9, "[0, \"t > 0 ? 1 : 0\", 0]");
    runAlone(readCase(second.write("case.yaml", tractions)), [](const std::string&) {});
    const auto expected = tableRows(second.read("postProcessing/case/0/watchPoints.dat"));
    ASSERT_EQ(rows.size(), expected.size());
    // The sum of the forces is the same, their distribution over the end is not quite.
    EXPECT_NEAR(rows.back()[2], expected.back()[2], 1e-3 * std::abs(expected.back()[2]));
    EXPECT_GT(std::abs(expected.back()[2]), 0.05 * expectedTip);
}

TEST(VolumeMesh, Bezier_hexahedra_are_the_volume_and_number_each_point_once) {
    const SolidDescription description = exampleVolume({Strains::linear, {}, true});
    const geometry::NurbsVolume& volume = description.volume;
    const SolidBody body(description);
    const VtuMesh mesh = bezierMesh(volume);
    ASSERT_EQ(mesh.cellSize, 27);
    ASSERT_EQ(mesh.connectivity.size(), 27u * 4);
    const std::set<std::int64_t> numbers(mesh.connectivity.begin(), mesh.connectivity.end());
    EXPECT_EQ(numbers.size(), mesh.connectivity.size());
    const Eigen::MatrixXd control = fileValues(mesh, body.positions(mesh.points));
    const auto quadratic = [](double t) {
        return Vector3d((1 - t) * (1 - t), 2 * t * (1 - t), t * t);
    };
    const Vector3d b = quadratic(0.3), c = quadratic(0.8), d = quadratic(0.6);
    for (int cell = 0; cell < 4; ++cell) {
        Vector3d sum = Vector3d::Zero();
        double denominator = 0;
        for (int k = 0; k < 27; ++k) {
            const double weight = b[k % 3] * c[k / 3 % 3] * d[k / 9] * mesh.weights[27 * cell + k];
            sum += weight * control.col(27 * cell + k);
            denominator += weight;
        }
        const Location& first = mesh.points[27 * cell];
        const Location& last = mesh.points[27 * cell + 26];
        const Vector3d expected = volume.point({first.xi + 0.3 * (last.xi - first.xi),
                                                first.eta + 0.8 * (last.eta - first.eta),
                                                first.zeta + 0.6 * (last.zeta - first.zeta)});
        EXPECT_LT((sum / denominator - expected).norm(), 1e-13);
    }
}

TEST(VolumeMesh, points_of_higher_Bezier_cells_lie_on_corners_edges_faces_and_inside_in_turn) {
    const geometry::NurbsVolume volume =
        geometry::refine(geometry::block({0, 0, 0}, {1, 1, 1}), {3, 4, 2}, {1, 1, 1});
    const VtuMesh mesh = bezierMesh(volume);
    const auto nEnds = [&](int k) {
        const Location& at = mesh.points[mesh.connectivity[k]];
        int n = 0;
        for (const double x : {at.xi, at.eta, at.zeta}) {
            n += x == 0 || x == 1;
        }
        return n;
    };
    const int nEdges = 4 * (2 + 3 + 1);
    const int nFaces = 2 * (2 * 3 + 3 * 1 + 2 * 1);
    for (int k = 0; k < mesh.cellSize; ++k) {
        EXPECT_EQ(nEnds(k), k < 8 ? 3 : k < 8 + nEdges ? 2 : k < 8 + nEdges + nFaces ? 1 : 0) << k;
    }
    // Corners counter-clockwise, the last zeta after the first.
    const Location& sixth = mesh.points[mesh.connectivity[6]];
    EXPECT_EQ(Vector3d(sixth.xi, sixth.eta, sixth.zeta), Vector3d(1, 1, 1));
    const Location& third = mesh.points[mesh.connectivity[3]];
    EXPECT_EQ(Vector3d(third.xi, third.eta, third.zeta), Vector3d(0, 1, 0));
}

TEST(VolumeMesh, hexahedra_fill_the_volume) {
    const SolidBody body(exampleVolume({Strains::linear, {}, false}));
    OutputOptions options;
    options.subdivision = 2;
    const VtuMesh mesh = body.meshes(options)[0];
    ASSERT_EQ(mesh.connectivity.size(), 8u * 8 * 8);
    const Eigen::MatrixXd x = body.positions(mesh.points);
    double volume = 0;
    for (std::size_t k = 0; k < mesh.connectivity.size(); k += 8) {
        // Of a cell: exact for a parallelepiped only.
        Eigen::Matrix3d edges;
        edges << x.col(mesh.connectivity[k + 1]) - x.col(mesh.connectivity[k]),
            x.col(mesh.connectivity[k + 3]) - x.col(mesh.connectivity[k]),
            x.col(mesh.connectivity[k + 4]) - x.col(mesh.connectivity[k]);
        EXPECT_GT(edges.determinant(), 0);
        volume += edges.determinant();
    }
    EXPECT_NEAR(volume, 2, 0.2);
}
