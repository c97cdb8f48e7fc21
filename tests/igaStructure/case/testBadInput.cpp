// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/brep/cadJson.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using testing::AllOf;
using testing::HasSubstr;

namespace {

// A static plate; lines 2, 4 and 7 hold geometry, model and support.
std::string plateText(const std::string& from = "", const std::string& to = "") {
    std::string text = "geometry:\n"
                       "  plate: {origin: [0, 0, 0], edgeXi: [1, 0, 0], edgeEta: [0, 1, 0]}\n"
                       "discretisation: {degree: [2, 2], elements: [2, 2]}\n"
                       "model: {kinematics: shell, strains: linear, thickness: 0.1}\n"
                       "material: {type: neoHookean, youngsModulus: 1e6, poissonsRatio: 0.3, "
                       "density: 1}\n"
                       "supports:\n"
                       "  - {edge: left, fix: [x, y, z, rotation]}\n"
                       "time: {scheme: static, step: 1, end: 1}\n";
    const auto place = text.find(from);
    if (place == std::string::npos) {
        throw std::logic_error("the example has no '" + from + "'");
    }
    return text.replace(place, from.size(), to);
}

std::string mistake(const std::string& text) {
    try {
        checkCase(readText(text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(BadInput, example_is_good) {
    EXPECT_EQ(mistake(plateText()), "no error");
}

TEST(BadInput, opposite_faces_of_a_solid_have_no_common_edge) {
    std::string text = plateText("kinematics: shell", "kinematics: solid");
    const std::string clamped = "edge: left, fix: [x, y, z, rotation]";
    text.replace(text.find(clamped), clamped.size(), "faces: [left, right], fix: [x, y, z]");
    const std::string inPlane = "degree: [2, 2], elements: [2, 2]";
    text.replace(text.find(inPlane), inPlane.size(), "degree: [2, 2, 2], elements: [2, 2, 1]");
    EXPECT_THAT(mistake(text),
                HasSubstr("supports[0].faces: faces that do not meet have no common edge"));
}

TEST(BadInput, supports_that_leave_rigid_motions_free_are_told_with_these) {
    EXPECT_THAT(mistake(plateText("fix: [x, y, z, rotation]", "fix: [x, z, rotation]")),
                AllOf(HasSubstr("case.yaml:7:3: supports: "),
                      HasSubstr("nothing prevents: translation along y; add supports")));
    std::string path = plateText("scheme: static", "scheme: arcLength");
    path.replace(path.find("[x, y, z, rotation]"), 19, "[x, y, z]");
    EXPECT_THAT(mistake(path),
                AllOf(HasSubstr("case.yaml:7:3: supports: "),
                      HasSubstr("nothing prevents: rotation about y through (0, 0.5, 0); add")));
}

TEST(BadInput, inverted_geometry_is_told_with_its_place) {
    const std::string solid =
        "  nurbs: {degree: [1, 1], knotsXi: [0, 0, 1, 1], knotsEta: [0, 0, 1, 1], "
        "controlPoints: [[1, 0], [0, 0], [1, 1], [0, 1]]}\n";
    EXPECT_THAT(
        mistake(exampleText("  rectangle: {origin: [-0.05, 0], size: [0.1, 1]}\n", solid)),
        AllOf(HasSubstr("case.yaml:2:89: geometry.nurbs.controlPoints: the geometry folds "
                        "over near x = "),
              HasSubstr("area element (that of the point, with its quadrature weight) is -"),
              HasSubstr("xi turns to eta counter-clockwise")));
    // Turns back at 5/9 of its length.
    const std::string shell =
        "nurbs: {degree: [2, 1], knotsXi: [0, 0, 0, 1, 1, 1], knotsEta: [0, 0, 1, 1], "
        "controlPoints: [[0, 0, 0], [1, 0, 0], [0.2, 0, 0], [0, 1, 0], [1, 1, 0], [0.2, 1, 0]]}";
    EXPECT_THAT(mistake(plateText("plate: {origin: [0, 0, 0], edgeXi: [1, 0, 0], edgeEta: "
                                  "[0, 1, 0]}",
                                  shell)),
                AllOf(HasSubstr("case.yaml:2:95: geometry.nurbs.controlPoints: the surface of "
                                "patch \"shell\" folds over (its normal turns by 180 degrees"),
                      HasSubstr("check its control points")));
}

namespace {

std::string beamText(const std::string& geometry) {
    return "geometry:\n  " + geometry +
           "\ndiscretisation: {degree: [2], elements: [2]}\n"
           "model: {kinematics: beam, strains: linear, thickness: 0.1}\n"
           "material: {type: StVenantKirchhoff, youngsModulus: 1, poissonsRatio: 0, density: 1}\n"
           "supports: []\n";
}

std::string solidText(const std::string& geometry, const std::string& model) {
    return "geometry:\n  " + geometry +
           "\ndiscretisation: {degree: [2, 2, 2], elements: [1, 1, 1]}\n"
           "model: {kinematics: solid, strains: linear" +
           model +
           "}\nmaterial: {type: StVenantKirchhoff, youngsModulus: 1, poissonsRatio: 0, "
           "density: 1}\nsupports: []\n";
}

} // namespace

TEST(BadInput, line_that_turns_back_or_stands_still_is_told_with_its_place) {
    // As the shell above.
    EXPECT_THAT(mistake(beamText("nurbs: {degree: [2], knotsXi: [0, 0, 0, 1, 1, 1], "
                                 "controlPoints: [[0, 0], [1, 0], [0.2, 0]]}")),
                AllOf(HasSubstr("case.yaml:2:68: geometry.nurbs.controlPoints: the line turns back "
                                "on itself between (0.5"),
                      HasSubstr("turns by 180 degrees"), HasSubstr("must run onwards")));
    EXPECT_THAT(mistake(beamText("nurbs: {degree: [2], knotsXi: [0, 0, 0, 1, 1, 1], "
                                 "controlPoints: [[3, 1], [3, 1], [3, 1]]}\n  slit: yes")),
                AllOf(HasSubstr("case.yaml:2:68: geometry.nurbs.controlPoints: "),
                      HasSubstr("has no tangent at (3, 1, 0): its line element is 0 m")));
    EXPECT_EQ(mistake(beamText("arc: {centre: [0, 0], radius: 1, angles: [0, 90]}")), "no error");
}

TEST(BadInput, solid_turned_inside_out_is_told_with_its_place) {
    EXPECT_THAT(
        mistake(solidText("nurbs: {degree: [1, 1, 1], knotsXi: [0, 0, 1, 1], knotsEta: [0, 0, 1, "
                          "1], knotsZeta: [0, 0, 1, 1], controlPoints: [[1, 0, 0], [0, 0, 0], [1, "
                          "1, 0], [0, 1, 0], [1, 0, 1], [0, 0, 1], [1, 1, 1], [0, 1, 1]]}",
                          "")),
        AllOf(HasSubstr("case.yaml:2:117: geometry.nurbs.controlPoints: the geometry is turned "
                        "inside out near x = "),
              HasSubstr("m^3 and must be positive"), HasSubstr("right-handed")));
    // Its inner surface would lie beyond the axis.
    EXPECT_THAT(mistake(solidText("cylinder: {base: [0, 0, 0], radius: 1, height: 1, angles: [0, "
                                  "90]}",
                                  ", thickness: 3")),
                AllOf(HasSubstr("case.yaml:2:13: geometry.cylinder: "),
                      HasSubstr("thinner than twice its radius of curvature")));
}

TEST(BadInput, thickness_of_zero_and_bodies_without_extent_are_told) {
    EXPECT_THAT(mistake(plateText("thickness: 0.1", "thickness: 0")),
                HasSubstr("case.yaml:4:56: model.thickness: 0 is out of range; allowed: (0, inf)"));
    EXPECT_THAT(
        mistake(plateText("edgeEta: [0, 1, 0]", "edgeEta: [2, 0, 0]")),
        AllOf(HasSubstr("case.yaml:2:10: geometry.plate: "), HasSubstr("edges are parallel")));
    const std::string beam = "geometry:\n  line: {from: [1, 2], to: [1, 2]}\n"
                             "discretisation: {degree: [2], elements: [2]}\n"
                             "model: {kinematics: beam, strains: linear, thickness: 0.1}\n"
                             "material: {type: StVenantKirchhoff, youngsModulus: 1, "
                             "poissonsRatio: 0, density: 1}\nsupports: []\n";
    EXPECT_THAT(mistake(beam), AllOf(HasSubstr("case.yaml:2:28: geometry.line.to: "),
                                     HasSubstr("length of the line is 0")));
}

TEST(BadInput, open_trimming_loop_is_told_with_file_and_ends) {
    const TemporaryDirectory directory;
    const geometry::TrimmedPatch patch(
        geometry::rectangle({0, 0, 0}, 1, 1),
        {geometry::TrimmingLoop::around({{0.123, 0.25}, {0.875, 0.75}})}, "plate");
    geometry::writeCadJson(geometry::BrepModel({{patch}}), directory.file("plate.json"));
    std::string json = directory.read("plate.json");
    const auto corner = json.find("0.123"); // the start of the first curve
    ASSERT_NE(corner, std::string::npos);
    directory.write("plate.json", json.replace(corner, 5, "0.133"));
    const std::string text = plateText(
        "plate: {origin: [0, 0, 0], edgeXi: [1, 0, 0], edgeEta: [0, 1, 0]}", "cadJson: plate.json");
    try {
        readCase(directory.write("case.yaml", text));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("plate.json"), HasSubstr("loop is open: curve"),
                                        HasSubstr("0.133"), HasSubstr("0.123")));
    }
}

TEST(BadInput, unknown_names_are_told_with_the_known_ones) {
    EXPECT_THAT(mistake(plateText("edge: left", "brepEdge: nowhere")),
                AllOf(HasSubstr("case.yaml:7:16: supports[0].brepEdge: "),
                      HasSubstr("no edge \"nowhere\"; it has shell.0")));
    EXPECT_THAT(mistake(plateText("thickness: 0.1",
                                  "thickness: 0.1, faceThickness: [{face: roof, thickness: 1}]")),
                AllOf(HasSubstr("case.yaml:4:"), HasSubstr("faceThickness[0].face: "),
                      HasSubstr("no face \"roof\""), HasSubstr("shell")));
    EXPECT_THAT(mistake(plateText("edge: left", "edgge: left")),
                AllOf(HasSubstr("case.yaml:7:6: supports[0]: unknown entry 'edgge'"),
                      HasSubstr("did you mean 'edge'?")));
}

TEST(BadInput, Poissons_ratio_is_wanted_but_of_an_incompressible_material) {
    EXPECT_THAT(mistake(plateText("poissonsRatio: 0.3, ", "")),
                AllOf(HasSubstr("case.yaml:5:11: material: entry 'poissonsRatio' is missing"),
                      HasSubstr("Poisson's ratio")));
    EXPECT_EQ(mistake(plateText("neoHookean, youngsModulus: 1e6, poissonsRatio: 0.3",
                                "incompressibleNeoHookean, youngsModulus: 1e6")),
              "no error");
}

TEST(BadInput, names_that_leave_the_results_folder_or_break_a_file_are_refused) {
    for (const char* name : {"../x", "a/b", ".hidden", "a<b", "\"a\\tb\""}) {
        EXPECT_THAT(mistake("name: " + std::string(name) + "\n" + exampleText()),
                    AllOf(HasSubstr("case.yaml:1:7: name: "), HasSubstr("cannot name results")))
            << name;
    }
    EXPECT_EQ(mistake("name: flap-2 b_3.4\n" + exampleText()), "no error");
}

TEST(BadInput, watch_point_names_that_break_a_table_are_refused) {
    for (const char* name : {"my tip", "a#b", "'tip[m]'", "\"a\\nb\""}) {
        EXPECT_THAT(mistake(exampleText("{name: tip", "{name: " + std::string(name))),
                    AllOf(HasSubstr("name: "), HasSubstr("cannot name columns of a table")))
            << name;
    }
    EXPECT_THAT(mistake(exampleText("    - {name: tip, at: [0, 1]}\n",
                                    "    - {name: tip, at: [0, 1]}\n"
                                    "    - {name: tip, at: [0, 0.5]}\n")),
                HasSubstr("case.yaml:24:14: output.watchPoints[1].name: 'tip' is the name of two"));
}

TEST(BadInput, closed_beam_is_told_that_it_is_not_joined) {
    EXPECT_THAT(
        mistake(beamText("nurbs: {degree: [2], knotsXi: [0, 0, 0, 1, 2, 2, 2], "
                         "controlPoints: [[0, 0], [2, 0], [0, 2], [0, 0]]}")),
        AllOf(HasSubstr("case.yaml:2:3: geometry: "), HasSubstr("its ends are not joined")));
}
