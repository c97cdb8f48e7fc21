// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/brep/cadJson.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/facesAtPoints.hpp"
#include "igaStructure/kinematics/shell/ShellBody.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

using namespace tokay;
using namespace tokay::structure;
using geometry::Points;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

// The roof of Scordelis and Lo: x is up, z along the roof.
std::string roofText(const std::string& from = "", const std::string& to = "") {
    std::string text = "geometry:\n"
                       "  cylinder: {base: [0, 0, 0], radius: 25, height: 50, angles: [-40, 40]}\n"
                       "discretisation: {degree: [3, 3], elements: [8, 8]}\n"
                       "model: {kinematics: shell, strains: linear, thickness: 0.25}\n"
                       "material: {type: StVenantKirchhoff, youngsModulus: 4.32e8, "
                       "poissonsRatio: 0, density: 1}\n"
                       "supports:\n"
                       "  - {edge: bottom, fix: [x, y]}\n"
                       "  - {edge: top, fix: [x, y]}\n"
                       "  - {point: [25, 0, 0], fix: [z]}\n"
                       "loads:\n"
                       "  - {traction: [-90, 0, 0]}\n"
                       "time: {scheme: static, step: 1, end: 1}\n"
                       "output:\n"
                       "  interval: 1\n"
                       "  watchPoints:\n"
                       "    - {name: free, at: [19.1511110779745, 16.0696902421635, 25]}\n";
    const auto place = text.find(from);
    if (place == std::string::npos) {
        throw std::logic_error("the example has no '" + from + "'");
    }
    return text.replace(place, from.size(), to);
}

std::vector<std::string> runText(const TemporaryDirectory& directory, const std::string& text) {
    std::vector<std::string> log;
    runAlone(readCase(directory.write("case.yaml", text)),
             [&](const std::string& line) { log.push_back(line); });
    return log;
}

std::string messageOf(const std::string& text) {
    try {
        makeBody(readText(text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(ShellCase, roof_sinks_as_published_and_leaves_its_fields) {
    const TemporaryDirectory directory;
    const std::vector<std::string> log = runText(directory, roofText());
    EXPECT_THAT(log[0], HasSubstr("Kirchhoff-Love shell, linear strains, 1 patch with 0 joints"));
    const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    EXPECT_NEAR(rows.back()[1], -0.3006, 5e-3 * 0.3006);
    for (const auto& entry : std::filesystem::directory_iterator(directory.file("results"))) {
        if (entry.path().extension() == ".vtu") {
            const std::string file = directory.read("results/" + entry.path().filename().string());
            EXPECT_THAT(file, HasSubstr("membraneForce"));
            EXPECT_THAT(file, HasSubstr("bendingMoment"));
        }
    }
}

TEST(ShellCase, model_of_a_cad_file_with_named_edges_is_the_same_roof) {
    const TemporaryDirectory directory;
    const auto part = [](double from, double to, const char* name) {
        return geometry::BrepFace{geometry::TrimmedPatch(
            geometry::cylinderPatch({0, 0, 0}, 25, 50, from * M_PI / 180, to * M_PI / 180), name)};
    };
    const std::vector<geometry::BrepFace> faces = {part(-40, 5, "one"), part(5, 40, "two")};
    geometry::writeCadJson(geometry::BrepModel(faces, geometry::coincidentEdges(faces, 1e-6)),
                           directory.file("roof.json"));
    std::string text = roofText("cylinder: {base: [0, 0, 0], radius: 25, height: 50, angles: "
                                "[-40, 40]}",
                                "cadJson: roof.json");
    const std::string supports = "  - {edge: bottom, fix: [x, y]}\n"
                                 "  - {edge: top, fix: [x, y]}\n";
    text.replace(text.find(supports), supports.size(),
                 "  - {brepEdge: one.0, fix: [x, y]}\n  - {brepEdge: one.2, fix: [x, y]}\n"
                 "  - {brepEdge: two.0, fix: [x, y]}\n  - {brepEdge: two.2, fix: [x, y]}\n");
    const std::vector<std::string> log = runText(directory, text);
    EXPECT_THAT(log[0], HasSubstr("2 patches with 1 joint"));
    const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    EXPECT_NEAR(rows.back()[1], -0.3006, 5e-3 * 0.3006);
}

TEST(ShellCase, check_names_what_is_free) {
    const std::string text = roofText("  - {point: [25, 0, 0], fix: [z]}\n", "");
    std::string dynamic = text;
    dynamic.replace(dynamic.find("scheme: static, "), 16, "");
    EXPECT_THAT(checkCase(readText(dynamic)), HasSubstr("translation along z"));
}

TEST(ShellCase, mistakes_are_told_with_their_place) {
    EXPECT_THAT(messageOf(roofText(", thickness: 0.25", "")), HasSubstr("thickness"));
    EXPECT_THAT(messageOf(roofText("[3, 3]", "[1, 1]")), HasSubstr("below the geometry's own"));
    EXPECT_THAT(messageOf(roofText("edge: bottom", "brepEdge: nowhere")),
                HasSubstr("no edge \"nowhere\""));
    EXPECT_THAT(messageOf(roofText("[25, 0, 0], fix", "[30, 0, 0], fix")),
                HasSubstr("lies 5 m outside the surface"));
    EXPECT_THAT(messageOf(roofText("traction: [-90, 0, 0]", "traction: [-90, 0]")),
                HasSubstr("loads[0].traction"));
    EXPECT_THAT(messageOf(roofText("kinematics: shell", "kinematics: planeStress")),
                HasSubstr("rectangle, nurbs"));
    EXPECT_THAT(messageOf(exampleText("StVenantKirchhoff", "neoHookean")),
                HasSubstr("'neoHookean' is not allowed; allowed: StVenantKirchhoff"));
}

TEST(ShellCase, shell_takes_whole_updates_if_the_case_does_not_say) {
    EXPECT_FALSE(readText(roofText()).newton.lineSearch);
    EXPECT_TRUE(readText(exampleText()).newton.lineSearch);
    EXPECT_TRUE(readText(roofText("time:", "newton: {lineSearch: yes}\ntime:")).newton.lineSearch);
}

TEST(ShellCase, the_extended_gradient_method_takes_the_strong_form_where_one_is_at_hand) {
    const TemporaryDirectory directory;
    const auto shellOf = [&](const std::string& scheme, const std::string& more) {
        std::string text = roofText("thickness: 0.25", "thickness: 0.25" + more);
        text.replace(text.find("scheme: static"), 14, "scheme: " + scheme);
        return std::get<ShellDescription>(readCase(directory.write("case.yaml", text)).structure);
    };
    const auto usual = shellOf("static", ", edgeMethod: egm");
    EXPECT_EQ(usual.weakEdgeMethod(), EdgeMethod::nitsche); // of joints
    EXPECT_FALSE(usual.egm.residual.has_value());           // whole, as strains are linear
    EXPECT_EQ(shellOf("generalisedAlpha", ", edgeMethod: egm").egm.residual, EgmResidual::none);
    EXPECT_EQ(shellOf("static", ", edgeMethod: egm, egm: {form: iterated}").egm.continuation,
              EgmContinuation::gradient);
    EXPECT_THAT([&] { shellOf("static", ", egm: {gamma: 1}"); },
                ThrowsMessage<InputError>(HasSubstr("goes with edgeMethod egm")));
    EXPECT_THAT([&] { shellOf("generalisedAlpha", ", edgeMethod: egm, egm: {residual: whole}"); },
                ThrowsMessage<InputError>(HasSubstr("strains linear and scheme static")));
}

TEST(ShellCase, explicit_schemes_take_soft_springs_and_leave_slivers_alone) {
    const TemporaryDirectory directory;
    const auto shellOf = [&](const std::string& scheme, const std::string& more) {
        std::string text = roofText("thickness: 0.25", "thickness: 0.25" + more);
        text.replace(text.find("scheme: static"), 14, "scheme: " + scheme);
        return readCase(directory.write("case.yaml", text)).structure;
    };
    const auto implicit = std::get<ShellDescription>(shellOf("static", ""));
    EXPECT_EQ(implicit.chosenEdgeMethod(), EdgeMethod::nitsche);
    EXPECT_EQ(implicit.sliverTreatment, SliverTreatment::extension);
    const auto steps = std::get<ShellDescription>(shellOf("explicit", ""));
    EXPECT_EQ(steps.chosenEdgeMethod(), EdgeMethod::penalty);
    EXPECT_EQ(steps.sliverTreatment, SliverTreatment::scaling);
    const auto chosen = std::get<ShellDescription>(shellOf("explicit", ", edgeMethod: lagrange"));
    EXPECT_EQ(chosen.chosenEdgeMethod(), EdgeMethod::lagrange);
    EXPECT_THROW(shellOf("explicit", ", sliverTreatment: extension"), InputError);
}

TEST(ShellCase, membrane_under_prestress_carries_pressure) {
    // A square membrane: the linear response to pressure is that of Poisson's equation,
    // 0.073671 p a^2 / (sigma t) in the middle (Timoshenko & Woinowsky-Krieger).
    const TemporaryDirectory directory;
    std::string text = "geometry:\n"
                       "  plate: {origin: [0, 0, 0], edgeXi: [2, 0, 0], edgeEta: [0, 2, 0]}\n"
                       "discretisation: {degree: [3, 3], elements: [12, 12]}\n"
                       "model: {kinematics: membrane, strains: linear, thickness: 0.01, "
                       "prestress: 1e5}\n"
                       "material: {type: StVenantKirchhoff, youngsModulus: 1e6, "
                       "poissonsRatio: 0.3, density: 1}\n"
                       "supports:\n";
    for (const char* edge : {"left", "right", "bottom", "top"}) {
        text += fmt::format("  - {{edge: {}, fix: [x, y, z]}}\n", edge);
    }
    text += "loads:\n"
            "  - {pressure: 10}\n"
            "time: {scheme: static, step: 1, end: 1}\n"
            "output: {watchPoints: [{name: middle, at: [1, 1, 0]}]}\n";
    runText(directory, text);
    const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    const double expected = 0.073671 * 10 * 4 / 1e3;
    EXPECT_NEAR(rows.back()[3], expected, 1e-3 * expected);
}

class ShellTransferKinds : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Strains, ShellTransferKinds, testing::Values("linear", "nonlinear"));

TEST_P(ShellTransferKinds, points_on_both_sides_keep_virtual_work_force_and_moment) {
    const std::unique_ptr<Body> body =
        makeBody(readText(roofText("strains: linear", std::string("strains: ") + GetParam())));
    Points points(4, 3);
    for (int k = 0; k < 4; ++k) {
        // Above and below the middle surface, over the whole roof.
        const double radius = 25 + (k % 2 == 0 ? 0.125 : -0.125);
        const double angle = -0.5 + 0.3 * k;
        points.row(k) << radius * std::cos(angle), radius * std::sin(angle), 5 + 12 * k;
    }
    Coupling coupling;
    coupling.method = TransferMethod::offset;
    coupling.loads = LoadTransfer::transposed;
    coupling.gapLimit = 0.1;
    const auto transfer = body->transfer(coupling, facesAtPoints(points));
    const Eigen::Index n = body->model().nUnknowns();
    const Eigen::VectorXd d = 0.05 * Eigen::VectorXd::Random(n);
    const Eigen::VectorXd v = Eigen::VectorXd::Random(n);
    const Points forces = Points::Random(4, 3);
    const double h = 1e-6;
    const Points motion =
        (transfer->displacements(d + h * v) - transfer->displacements(d - h * v)) / (2 * h);
    const double work = motion.cwiseProduct(forces).sum();
    EXPECT_NEAR(transfer->forces(d, forces).dot(v), work, 1e-7 * std::abs(work));
    const Eigen::VectorXd onNodes = transfer->forces(d, forces);
    const Eigen::Map<const Points> rows(onNodes.data(), n / 3, 3);
    EXPECT_LT((rows.colwise().sum() - forces.colwise().sum()).norm(), 1e-10 * forces.norm());
}

TEST(ShellBody, material_points_through_the_thickness_are_found_and_turn_with_the_section) {
    const std::unique_ptr<Body> body =
        makeBody(readText(roofText("strains: linear", "strains: nonlinear")));
    const Eigen::Vector3d outside(25.1 * std::cos(0.2), 25.1 * std::sin(0.2), 20);
    const Body::Closest found = body->closest(outside);
    EXPECT_NEAR(found.distance, 0, 1e-9);
    EXPECT_NEAR(found.location.zeta, 0.1, 1e-9);
    EXPECT_GT(body->closest(1.1 * outside).distance, 1);
    // A rotation about z moves every material point as space.
    const auto& shell = dynamic_cast<const Shell&>(body->model());
    Eigen::VectorXd d(shell.nUnknowns());
    const Eigen::AngleAxisd rotation(1.0, Eigen::Vector3d::UnitZ());
    for (int k = 0; k < shell.nodes().count(); ++k) {
        const Eigen::Vector3d X = shell.nodes().positions.row(k);
        d.segment<3>(3 * k) = rotation * X - X;
    }
    const Eigen::Vector3d moved = body->displacements(d, {found.location}).col(0);
    EXPECT_LT((moved - (rotation * outside - outside)).norm(), 1e-9 * 25);
}

TEST(ShellBody, result_file_of_a_trimmed_patch_covers_what_its_loops_keep) {
    const geometry::NurbsCurve circle = geometry::arc({0.45, 0.5, 0}, 0.2, 0, 2 * M_PI);
    const geometry::NurbsCurve clockwise(circle.knotVector(),
                                         circle.controlPoints().colwise().reverse(),
                                         circle.weights().reverse());
    const geometry::TrimmedPatch patch(
        geometry::rectangle({0, 0, 0}, 1, 1),
        {geometry::TrimmingLoop(geometry::LoopKind::inner, {clockwise})}, "plate");
    const ShellBody body(
        ShellDescription{geometry::BrepModel({{patch.refined(2, 2, 6, 6)}}), {0.1}, {1e6, 0.3, 1}});
    const VtuMesh mesh = body.meshes(OutputOptions())[0];
    ASSERT_EQ(mesh.cellSize, 3);
    const Eigen::MatrixXd x = body.positions(mesh.points);
    double area = 0;
    for (std::size_t k = 0; k < mesh.connectivity.size(); k += 3) {
        const Eigen::Vector3d a = x.col(mesh.connectivity[k]);
        const Eigen::Vector3d b = x.col(mesh.connectivity[k + 1]);
        const Eigen::Vector3d c = x.col(mesh.connectivity[k + 2]);
        area += 0.5 * (b - a).cross(c - a)[2];
    }
    const double expected = 1 - M_PI * 0.2 * 0.2;
    EXPECT_NEAR(area, expected, 1e-2 * expected); // chords of the circle
    MotionState atRest;
    atRest.displacement = Eigen::VectorXd::Zero(body.model().nUnknowns());
    const Eigen::MatrixXd stress = body.field("principalStressTop").evaluate(atRest, mesh.points);
    EXPECT_EQ(stress.cols(), static_cast<Eigen::Index>(mesh.points.size()));
    EXPECT_EQ(stress.norm(), 0);
}
