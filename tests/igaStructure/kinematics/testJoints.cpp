// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"
#include "temporaryDirectory.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

using namespace tokay;
using namespace tokay::structure;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

std::string caseFile(const std::string& name) {
    return std::string(TOKAY_SOURCE_DIR) + "/tests/igaStructure/cases/" + name;
}

/// Last row of the watch points after a run: the time, then displacements.
std::vector<double> finalMotion(const std::string& text) {
    const TemporaryDirectory directory;
    runAlone(readCase(directory.write("case.yaml", text)), [](const std::string&) {});
    return tableRows(directory.read("postProcessing/case/0/watchPoints.dat")).back();
}

std::string messageOf(const std::string& text) {
    try {
        checkCase(readText(text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

// Rows of control points of a full circle of quarters.
std::string circle(double radius) {
    std::string points;
    for (int k = 0; k <= 8; ++k) {
        constexpr int x[] = {1, 1, 0, -1, -1, -1, 0, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1};
        points += fmt::format("[{}, {}], ", radius * x[k % 8], radius * y[k % 8]);
    }
    return points;
}

const std::string circleWeights = "1, 0.7071067811865476, 1, 0.7071067811865476, 1, "
                                  "0.7071067811865476, 1, 0.7071067811865476, 1";

/// An annulus; xi runs around it, eta from the first radius to the second.
std::string annulus(double first, double second) {
    return "nurbs: {degree: [2, 1], knotsXi: [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], "
           "knotsEta: [0, 0, 1, 1], controlPoints: [" +
           circle(first) + circle(second) + "], weights: [" + circleWeights + ", " + circleWeights +
           "]}";
}

std::string pipeText(const std::string& slit) {
    return "geometry: {cylinder: {base: [0, 0, 0], radius: 1.1, height: 0.2, angles: [0, 360]}" +
           slit +
           "}\ndiscretisation: {degree: [3, 2, 3], elements: [4, 1, 2]}\n"
           "model: {kinematics: solid, strains: linear, thickness: 0.2}\n"
           "material: {type: StVenantKirchhoff, youngsModulus: 1e6, poissonsRatio: 0.3, "
           "density: 1000}\n"
           "supports: [{faces: [bottom], fix: [z]}, {faces: [top], fix: [z]}, "
           "{faces: [left], fix: [y]}, {faces: [left, bottom, back], fix: [x]}]\n"
           "loads: [{face: back, pressure: 100}]\n"
           "time: {scheme: static, step: 1, end: 1}\n"
           "output: {interval: 0, watchPoints: [{name: n, at: [0, 1.1, 0.1]}, "
           "{name: w, at: [-1.1, 0, 0.1]}]}\n";
}

std::string plates(const std::string& geometry, const std::string& rest) {
    return "geometry: {" + geometry +
           "}\ndiscretisation: {degree: [3, 3], elements: [4, 4]}\n"
           "model: {kinematics: shell, strains: linear, thickness: 0.1}\n"
           "material: {type: StVenantKirchhoff, youngsModulus: 1e7, poissonsRatio: 0.3, "
           "density: 1}\n"
           "time: {scheme: static, step: 1, end: 1}\n"
           "output: {interval: 0, watchPoints: [{name: t, at: [12, 2, 0]}]}\n" +
           rest;
}

std::string platesWithoutEdge() {
    return "cadJson: " + caseFile("platesWithoutEdge.cad.json");
}

const std::string clamped = "supports: [{brepEdge: \"8\", fix: [x, y, z, rotation]}]\n";
const std::string lifted = "loads: [{traction: [0, 0, 0.1]}]\n";

} // namespace

TEST(Joints, pipe_as_solid_is_closed_along_its_seam) {
    // Lame's pipe in plane strain, radii 1 and 1.2 under 100 Pa inside.
    const auto radial = [](double r) { return 1.3e-6 * 100 / (1.44 - 1) * (0.4 * r + 1.44 / r); };
    const std::vector<double> motion = finalMotion(pipeText(""));
    // The corner at (1, 0) keeps its x, so all moves by its radial displacement.
    constexpr double tolerance = 1e-5; // of cubic elements of 22.5 degrees
    EXPECT_NEAR(motion[1], -radial(1), tolerance * radial(1));
    EXPECT_NEAR(motion[2], radial(1.1), tolerance * radial(1.1));
    EXPECT_NEAR(motion[4], -radial(1.1) - radial(1), tolerance * radial(1));
    EXPECT_THAT(checkCase(readText(pipeText(""))), HasSubstr(", closed along xi\n"));
}

TEST(Joints, pipe_opens_where_the_case_says_slit) {
    const std::string text = pipeText(", slit: yes");
    EXPECT_THAT(checkCase(readText(text)), Not(HasSubstr("closed")));
    EXPECT_GT(std::abs(finalMotion(text)[1]), 0.01);
}

TEST(Joints, plane_ring_vibrates_as_a_closed_ring) {
    // Without supports: three rigid motions, then twice the ovalling mode of a thin ring,
    // w^2 = E I / (rho A R^4) n^2 (n^2 - 1)^2 / (n^2 + 1) with n = 2 (Love).
    const auto frequencies = [](const std::string& slit) {
        const std::string text =
            "geometry: {" + annulus(1.01, 0.99) + slit +
            "}\ndiscretisation: {degree: [3, 2], elements: [16, 1]}\n"
            "model: {kinematics: planeStress, strains: linear, thickness: 1}\n"
            "material: {type: StVenantKirchhoff, youngsModulus: 1e6, poissonsRatio: 0, "
            "density: 1000}\nsupports: []\ntime: {step: 1, end: 1}\n";
        return naturalModes(makeBody(readText(text))->model(), 5).angularFrequencies;
    };
    const double expected = std::sqrt(1e6 / 1000 * 0.02 * 0.02 / 12 * 36 / 5);
    const Eigen::VectorXd closed = frequencies("");
    const Eigen::VectorXd open = frequencies(", slit: yes");
    for (int k = 0; k < 3; ++k) {
        EXPECT_LT(closed[k], 1e-2 * expected); // squares are the last digits of the highest
        EXPECT_LT(open[k], 1e-2 * expected);
    }
    EXPECT_NEAR(closed[3], expected, 2e-3 * expected); // thickness over radius, squared, and mesh
    EXPECT_NEAR(closed[4], closed[3], 1e-3 * expected);
    EXPECT_GT(open[3], 1e-2 * expected);
    EXPECT_LT(open[3], 0.5 * expected);
}

TEST(Joints, annulus_of_a_shell_stays_open_where_the_case_says_slit) {
    const auto text = [](const std::string& slit) {
        return "geometry: {" + annulus(6, 10) + slit +
               "}\ndiscretisation: {degree: [3, 3], elements: [2, 2]}\n"
               "model: {kinematics: shell, strains: linear, thickness: 0.03}\n"
               "material: {type: StVenantKirchhoff, youngsModulus: 21e6, poissonsRatio: 0, "
               "density: 1}\n"
               "supports: [{edge: left, fix: [x, y, z, rotation]}]\n"
               "loads: [{edge: right, lineForce: [0, 0, 1e-3]}]\n"
               "time: {scheme: static, step: 1, end: 1}\n"
               "output: {interval: 0, watchPoints: [{name: B, at: [10, 0, 0]}]}\n";
    };
    EXPECT_THAT(checkCase(readText(text(""))),
                AllOf(HasSubstr("1 patch with 1 joint,"),
                      HasSubstr("joined where edges coincide (geometry.slit: yes keeps them open): "
                                "shell.1-shell.3\n")));
    EXPECT_THAT(checkCase(readText(text(", slit: yes"))),
                AllOf(HasSubstr("1 patch with 0 joints,"), Not(HasSubstr("coincide"))));
}

TEST(Joints, plates_whose_file_shares_no_edge_are_joined_where_they_touch) {
    const double tip = finalMotion(plates(platesWithoutEdge(), clamped + lifted))[3];
    // One plate of the same length and elements, clamped at the same end.
    std::string whole = plates("plate: {origin: [0, 0, 0], edgeXi: [12, 0, 0], edgeEta: [0, 4, 0]}",
                               "supports: [{edge: left, fix: [x, y, z, rotation]}]\n" + lifted);
    whole.replace(whole.find("[4, 4]"), 6, "[8, 4]");
    const double expected = finalMotion(whole)[3];
    EXPECT_NEAR(tip, expected, 1e-3 * expected); // the joint is weak, its curvature free to jump
    EXPECT_THAT(checkCase(readText(plates(platesWithoutEdge(), clamped + lifted))),
                HasSubstr("joined where edges coincide (geometry.slit: yes keeps them open): "
                          "1.1-2.3\n"));
}

TEST(Joints, patch_that_nothing_supports_or_joins_is_refused) {
    EXPECT_THAT(
        messageOf(plates(platesWithoutEdge() + ", slit: yes", clamped + lifted)),
        HasSubstr("supports: nothing supports or joins: patch 2; let their edges coincide"));
}

TEST(Joints, pressure_on_a_face_with_swapped_normal_acts_the_other_way) {
    const TemporaryDirectory directory;
    std::ifstream file(caseFile("platesWithoutEdge.cad.json"));
    std::string content((std::istreambuf_iterator<char>(file)), {});
    const std::string flag = "\"swapped_surface_normal\": false";
    for (std::size_t at = content.find(flag); at != std::string::npos; at = content.find(flag)) {
        content.replace(at, flag.size(), "\"swapped_surface_normal\": true");
    }
    const std::string swapped = "cadJson: " + directory.write("swapped.cad.json", content);
    const std::string loads = clamped + "loads: [{pressure: 0.1}]\n";
    const double tip = finalMotion(plates(platesWithoutEdge(), loads))[3];
    EXPECT_GT(tip, 0.1);
    // The same elements, mirrored: rounding.
    EXPECT_NEAR(finalMotion(plates(swapped, loads))[3], -tip, 1e-6 * tip);
}

TEST(Joints, edge_that_is_a_point_runs) {
    const std::string text = "geometry: {cadJson: " + caseFile("edgeAtPole.cad.json") +
                             "}\ndiscretisation: {degree: [2, 2], elements: [2, 2]}\n"
                             "model: {kinematics: shell, strains: linear, thickness: 0.01}\n"
                             "material: {type: StVenantKirchhoff, youngsModulus: 1e7, "
                             "poissonsRatio: 0.3, density: 100}\n"
                             "supports: []\nloads: [{gravity: [0, 0, 1]}]\n"
                             "time: {step: 1, end: 1}\noutput: {interval: 0}\n";
    const TemporaryDirectory directory;
    EXPECT_NO_THROW(
        runAlone(readCase(directory.write("case.yaml", text)), [](const std::string&) {}));
}

TEST(Joints, remarks_on_a_cad_file_are_in_the_log) {
    EXPECT_THAT(checkCase(readText(plates(platesWithoutEdge(), clamped + lifted))),
                Not(HasSubstr("note: ")));
    std::ifstream file(caseFile("platesWithoutEdge.cad.json"));
    std::string cad{std::istreambuf_iterator<char>(file), {}};
    const std::string none = "\"vertices\": []";
    ASSERT_NE(cad.find(none), std::string::npos);
    cad.replace(cad.find(none), none.size(), "\"vertices\": [{\"brep_id\": 99}]");
    const TemporaryDirectory directory;
    const std::string geometry = "cadJson: " + directory.write("remarked.cad.json", cad);
    EXPECT_THAT(checkCase(readText(plates(geometry, clamped + lifted))),
                AllOf(HasSubstr("  note: "), HasSubstr("1 vertices are not used")));
}

TEST(Joints, control_point_far_away_is_read) {
    const std::string text = "geometry: {cadJson: " + caseFile("farControlPoint.cad.json") +
                             "}\ndiscretisation: {degree: [3, 3], elements: [2, 2]}\n"
                             "model: {kinematics: shell, strains: linear, thickness: 0.01}\n"
                             "material: {type: StVenantKirchhoff, youngsModulus: 1e7, "
                             "poissonsRatio: 0.3, density: 100}\n"
                             "supports: []\ntime: {step: 1, end: 1}\n";
    EXPECT_EQ(messageOf(text), "no error");
    EXPECT_THAT(checkCase(readText(text)),
                AllOf(HasSubstr("times as far out as half of the others: check the geometry"),
                      Not(HasSubstr("slenderness"))));
}

TEST(Joints, edges_are_joined_up_to_the_tolerance_of_the_case) {
    // The second plate lies 1e-4 above the first; the file's tolerance is 1e-3.
    std::ifstream file(caseFile("platesWithoutEdge.cad.json"));
    std::string cad{std::istreambuf_iterator<char>(file), {}};
    for (const char* point : {"[13, [6, 0, 0, 1]]", "[14, [12, 0, 0, 1]]", "[15, [6, 4, 0, 1]]",
                              "[16, [12, 4, 0, 1]]"}) {
        std::string raised = point;
        raised.replace(raised.find(", 0, 1]"), 7, ", 1e-4, 1]");
        ASSERT_NE(cad.find(point), std::string::npos);
        cad.replace(cad.find(point), std::string(point).size(), raised);
    }
    const TemporaryDirectory directory;
    const std::string geometry = "cadJson: " + directory.write("plates.cad.json", cad);
    const std::string joined = "joined where edges coincide";
    const std::string rest = clamped + lifted;
    EXPECT_THAT(checkCase(readText(plates(geometry, rest))), HasSubstr(joined));
    EXPECT_THAT(checkCase(readText(plates(geometry + ", tolerance: 2e-4", rest))),
                HasSubstr(joined));
    EXPECT_THAT(messageOf(plates(geometry + ", tolerance: 1e-5", rest)),
                HasSubstr("nothing supports or joins: patch 2"));
    EXPECT_THAT(
        messageOf(plates("rectangle: {origin: [0, 0], size: [12, 4]}, tolerance: 1e-3", rest)),
        HasSubstr("geometry.tolerance: goes with cadJson"));
}
