// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleBeamCase.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/beam/BeamBody.hpp"
#include "igaStructure/linearAlgebra/SparseCholesky.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;
using testing::HasSubstr;

namespace {

std::string mistake(const std::string& from, const std::string& to) {
    try {
        makeBody(readText(exampleBeamText(from, to)));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

const BeamSection& sectionOf(const Case& read) {
    return std::get<BeamDescription>(read.structure).section;
}

std::vector<std::vector<double>> runText(const TemporaryDirectory& directory,
                                         const std::string& text) {
    runAlone(readCase(directory.write("case.yaml", text)), [](const std::string&) {});
    return tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
}

std::unique_ptr<Body> exampleBody(const std::string& from = "", const std::string& to = "") {
    return makeBody(readText(exampleBeamText(from, to)));
}

} // namespace

TEST(BeamCase, section_follows_from_thickness_and_plane_strain) {
    const BeamSection strip = sectionOf(readText(exampleBeamText()));
    EXPECT_NEAR(strip.axialStiffness, 4e6 / 0.91 * 0.1, 1e-9);
    EXPECT_NEAR(strip.bendingStiffness, 4e6 / 0.91 * 1e-3 / 12, 1e-12);
    EXPECT_NEAR(strip.mass, 300, 1e-12);
    EXPECT_EQ(strip.rotaryInertia, 0);
    const BeamSection rod = sectionOf(readText(
        exampleBeamText("thickness: 0.1", "thickness: 0.1, section: planeStress, width: 0.2")));
    EXPECT_NEAR(rod.bendingStiffness, 4e6 * 0.2 * 1e-3 / 12, 1e-12);
    EXPECT_NEAR(rod.mass, 60, 1e-12);
}

TEST(BeamCase, mistakes_are_reported_with_their_place) {
    EXPECT_THAT(
        mistake("end: start, fix", "edge: bottom, fix"),
        HasSubstr(
            "case.yaml:11:6: supports[0]: 'edge' is not an option of beam; allowed: end, fix"));
    EXPECT_THAT(mistake(", thickness: 0.1", ""), HasSubstr("model: entry 'thickness' is missing"));
    EXPECT_THAT(mistake("thickness: 0.1", "thickness: 0.1, rotaryInertia: yes"),
                HasSubstr("model.rotaryInertia: yes is not available with nonlinear strains"));
    EXPECT_THAT(mistake("degree: [3]", "degree: [3, 3]"),
                HasSubstr("discretisation.degree: must have 1 value, but has 2"));
    EXPECT_THAT(mistake("degree: [3]", "degree: [1]"), HasSubstr("degree 2 or more"));
    EXPECT_THAT(mistake("traction: [\"100*y\", 0]", "force: [1, 0]"),
                HasSubstr("loads[0]: entry 'end' is missing: force and moment act on one"));
    EXPECT_THAT(mistake("traction: [\"100*y\", 0]", "end: end"),
                HasSubstr("loads[0]: give force or moment at the end"));
    EXPECT_THAT(mistake("output:", "coupling: {interface: [left]}\noutput:"),
                HasSubstr("coupling: 'interface' is not an option of beam"));
    EXPECT_THAT(mistake("line: {from: [0, 0], to: [0, 1]}",
                        "arc: {centre: [0, 0], radius: 1, angles: [0, 180]}"),
                HasSubstr("the basis has a hinge"));
}

TEST(BeamCase, newton_takes_whole_updates_unless_the_case_says_otherwise) {
    EXPECT_FALSE(readText(exampleBeamText()).newton.lineSearch);
    EXPECT_TRUE(
        readText(exampleBeamText("time:", "newton: {lineSearch: yes}\ntime:")).newton.lineSearch);
}

TEST(BeamCase, end_moment_rolls_the_flap_up_in_few_iterations) {
    std::string text = exampleBeamText("  - {traction: [\"100*y\", 0]}",
                                       "  - {end: end, moment: \"t*2*pi*366.3003663\"}");
    text.replace(text.find("time: {step: 0.01, end: 0.1"), 27,
                 "newton: {maxIterations: 12}\ntime: {scheme: static, step: 0.05, end: 1");
    const TemporaryDirectory directory;
    const auto rows = runText(directory, text); // throws if it takes more
    EXPECT_NEAR(rows.back()[2], -1, 0.02);      // degree 3, 8 elements
}

TEST(BeamCase, flap_as_a_beam_swings_as_the_solid_does) {
    // Published first peak of linear solids under this traction: 0.0509 m at 0.82 s.
    // Shear deformation, which the beam leaves out, is about 1 % of it.
    std::string text = exampleBeamText("end: 0.1", "end: 1");
    text.replace(text.find("nonlinear"), 9, "linear");
    const TemporaryDirectory directory;
    const auto rows = runText(directory, text);
    const auto peak = *std::max_element(rows.begin(), rows.end(),
                                        [](const auto& a, const auto& b) { return a[1] < b[1]; });
    EXPECT_NEAR(peak[1], 0.0509, 0.015 * 0.0509);
    EXPECT_NEAR(peak[0], 0.82, 0.011);
}

TEST(BeamCase, watch_point_beside_the_axis_turns_with_its_section) {
    const TemporaryDirectory directory;
    const auto rows = runText(directory, exampleBeamText("100*y", "2000*y"));
    const std::vector<double>& last = rows.back();
    // Tip and corner keep their distance of 0.05; the corner sinks where the tip leans.
    EXPECT_NEAR(std::hypot(last[3] - last[1] + 0.05, last[4] - last[2]), 0.05, 1e-10);
    EXPECT_LT(last[4], last[2]);
}

TEST(BeamCase, watch_point_outside_the_thickness_is_reported) {
    const TemporaryDirectory directory;
    try {
        runText(directory, exampleBeamText("at: [0.05, 1]", "at: [0.06, 1]"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("'corner' at [0.06, 1] lies 0.01 m outside the body; "
                                            "its nearest point is [0.05, 1]"));
    }
}

TEST(BeamCase, check_says_what_would_be_modelled) {
    const std::string text = checkCase(readText(exampleBeamText()));
    EXPECT_THAT(text, HasSubstr("Euler-Bernoulli beam, nonlinear strains, degree 3, 8 elements"));
    EXPECT_THAT(text, HasSubstr("bending stiffness 366.3 N m^2"));
    EXPECT_THAT(text, HasSubstr("22 unknowns, 3 of them fixed"));
}

TEST(BeamCase, results_show_the_thick_body_or_the_exact_axis) {
    const std::unique_ptr<Body> body = exampleBody();
    OutputOptions options;
    options.subdivision = 2;
    const VtuMesh strip = body->meshes(options)[0];
    const Eigen::MatrixXd points = body->positions(strip.points);
    double area = 0;
    for (std::size_t k = 0; k < strip.connectivity.size(); k += 4) {
        const auto corner = [&](int i) -> Eigen::Vector3d {
            return points.col(strip.connectivity[k + i]);
        };
        area += 0.5 * (corner(2) - corner(0)).cross(corner(3) - corner(1))[2];
    }
    EXPECT_NEAR(area, 0.1, 1e-13); // counter-clockwise: positive

    const std::unique_ptr<Body> arc = exampleBody(
        "line: {from: [0, 0], to: [0, 1]}", "arc: {centre: [0, 0], radius: 1, angles: [0, 90]}");
    options.cells = CellShape::bezier;
    const VtuMesh axis = arc->meshes(options)[0];
    const Eigen::MatrixXd control = fileValues(axis, arc->positions(axis.points));
    ASSERT_EQ(axis.cellSize, 4);
    // Middle of the first cell, by Bernstein polynomials: on the circle.
    const Eigen::Vector4d bernstein(0.125, 0.375, 0.375, 0.125);
    const Eigen::Vector4d weights = bernstein.cwiseProduct(axis.weights.head<4>());
    EXPECT_NEAR((control.leftCols<4>() * weights / weights.sum()).norm(), 1, 1e-14);
}

TEST(BeamCase, fields_have_the_values_of_the_cantilever) {
    const std::unique_ptr<Body> body = exampleBody("nonlinear", "linear");
    MotionState state;
    state.displacement = VectorXd::Zero(body->model().nUnknowns());
    SparseMatrix tangent;
    body->model().internalForce(state.displacement, tangent);
    SparseCholesky solver(tangent, body->model().fixed());
    solver.factorise(tangent);
    state.displacement = solver.solve(body->model().externalForce(0));
    // At the middle of an element, where cubic splines have their best moment and
    // shear, on the left side, which is -x of an upward axis.
    const double y = 4.5 / 8;
    const std::vector<Location> left = {{0, y, 0, 0.05}};
    const double moment = body->field("bendingMoment").evaluate(state, left)(0, 0);
    // The traction 100 y to the right turns the tangent to the right.
    EXPECT_NEAR(moment, -100 * ((1 - y * y * y) / 3 - y * (1 - y * y) / 2), 0.1);
    EXPECT_NEAR(body->field("shearForce").evaluate(state, left)(0, 0), -50 * (1 - y * y), 0.3);
    EXPECT_NEAR(body->field("axialStress").evaluate(state, left)(0, 0), -0.05 * moment * 12 / 1e-3,
                1e-6);
    EXPECT_NEAR(body->field("normalForce").evaluate(state, left)(0, 0), 0, 1e-6);
}

TEST(BeamCase, load_step_that_is_too_large_is_taken_in_halves) {
    // A full circle in one load step.
    std::string text = exampleBeamText("  - {traction: [\"100*y\", 0]}",
                                       "  - {end: end, moment: \"t*2*pi*366.3003663\"}");
    const std::string whole = "newton: {lineSearch: yes}\ntime: {scheme: static, step: 1, end: 1";
    text.replace(text.find("time: {step: 0.01, end: 0.1"), 27, whole);
    const TemporaryDirectory directory;
    EXPECT_THROW(runText(directory, text), SolverError);
    text.replace(text.find(whole), whole.size(), whole + ", minDeltaT: 0.001");
    const auto rows = runText(directory, text);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_NEAR(rows[0][1], 0, 0.02); // degree 3, 8 elements
    EXPECT_NEAR(rows[0][2], -1, 0.02);
}

TEST(BeamCase, arc_length_run_reaches_its_end_or_its_number_of_steps) {
    const std::string from = "time: {step: 0.01, end: 0.1";
    const std::string loads = "\"100*y\"";
    std::string text = exampleBeamText(loads, "\"1000*t\"");
    text.replace(text.find(from), from.size(), "time: {scheme: arcLength, step: 0.1, end: 1");
    const TemporaryDirectory directory;
    const auto rows = runText(directory, text);
    EXPECT_GE(rows.back()[0], 1);
    EXPECT_LT(rows[rows.size() - 2][0], 1);
    text.replace(text.find("end: 1}"), 7, "end: 1, maxSteps: 3}");
    EXPECT_EQ(runText(directory, text).size(), 3u);
}
