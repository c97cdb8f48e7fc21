// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/beam/BeamBody.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/run/runModes.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using testing::AllOf;
using testing::HasSubstr;

namespace {

// A cantilever in space of length 3 and thickness 0.05, E = 2e8, pulled across.
const std::string beamText =
    "geometry:\n"
    "  line: {from: [0, 0, 0], to: [1, 2, 2]}\n"
    "discretisation: {degree: [3], elements: [8]}\n"
    "model: {kinematics: beam, strains: linear, thickness: 0.05}\n"
    "material: {type: StVenantKirchhoff, youngsModulus: 2e8, poissonsRatio: 0.3, density: 1000}\n"
    "supports:\n"
    "  - {end: start, fix: [x, y, z, rotation]}\n"
    "loads:\n"
    "  - {end: end, force: [\"2*t\", 0, \"-t\"]}\n" // across the line
    "time: {scheme: static, step: 1, end: 1}\n"
    "output:\n"
    "  interval: 1\n"
    "  watchPoints:\n"
    "    - {name: tip, at: [1, 2, 2]}\n";

// A cable over a span of 5, at first a parabola with a sag of 1.5.
const std::string cableText =
    "geometry:\n"
    "  nurbs: {degree: [2], knotsXi: [0, 0, 0, 1, 1, 1], "
    "controlPoints: [[0, 0, 5], [2, 1.5, 2], [4, 3, 5]]}\n"
    "discretisation: {degree: [3], elements: [16]}\n"
    "model: {kinematics: cable, strains: nonlinear, thickness: 0.02, prestress: 1e5}\n"
    "material: {type: StVenantKirchhoff, youngsModulus: 1e8, poissonsRatio: 0.3, density: 8000}\n"
    "supports:\n"
    "  - {end: start, fix: [x, y, z]}\n"
    "  - {end: end, fix: [x, y, z]}\n"
    "loads:\n"
    "  - {gravity: [0, 0, \"-9.81*t\"]}\n"
    "time: {scheme: static, step: 0.1, end: 1, minDeltaT: 0.01}\n"
    "output:\n"
    "  interval: 0\n"
    "  watchPoints:\n"
    "    - {name: middle, at: [2, 1.5, 3.5]}\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

std::string mistake(const std::string& text) {
    try {
        makeBody(readText(text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::vector<std::vector<double>> runText(const TemporaryDirectory& directory,
                                         const std::string& text) {
    runAlone(readCase(directory.write("case.yaml", text)), [](const std::string&) {});
    return tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
}

} // namespace

TEST(SpatialBeamCase, cantilever_bends_as_a_square_rod) {
    const TemporaryDirectory directory;
    const auto rows = runText(directory, beamText);
    const double flexibility = 27 / (3 * 2e8 * std::pow(0.05, 4) / 12); // L^3 / 3 E I
    ASSERT_EQ(rows.back().size(), 4u);
    EXPECT_NEAR(rows.back()[1], 2 * flexibility, 1e-8 * flexibility);
    EXPECT_NEAR(rows.back()[2], 0, 1e-8 * flexibility);
    EXPECT_NEAR(rows.back()[3], -flexibility, 1e-8 * flexibility);
    EXPECT_THAT(directory.read("results/case.pvd"), HasSubstr("timestep=\"1\""));
}

TEST(SpatialBeamCase, cable_hangs_in_the_plane_of_its_ends_as_the_elastic_catenary) {
    const double EA = 1e8 * 4e-4;
    const double w = 8000 * 4e-4 * 9.81;
    const double parabola = 2.5 * std::sqrt(2.44) + 25.0 / 12 * std::asinh(1.2); // its length
    const double L = parabola * std::sqrt(1 - 2 * 1e5 / 1e8);                    // unstretched
    // span = 2 H/w asinh(w L / 2 H) + H L / EA (Irvine 1981) grows with H.
    double H = 0;
    for (double step = 1024; step > 1e-12; step /= 2) {
        const double next = H + step;
        H = 2 * next / w * std::asinh(w * L / (2 * next)) + next * L / EA < 5 ? next : H;
    }
    const double V = 0.5 * w * L;
    const double sag = (std::hypot(H, V) - H) / w + 0.5 * V * L / (2 * EA);
    const TemporaryDirectory directory;
    const std::vector<double> last = runText(directory, cableText).back();
    EXPECT_NEAR(last[1], 0, 1e-9); // symmetric about the middle
    EXPECT_NEAR(last[2], 0, 1e-9);
    EXPECT_NEAR(1.5 - last[3], sag, 1e-4 * sag); // discretisation 1e-5, measure of strain 1e-5
}

TEST(SpatialBeamCase, frequencies_and_shapes_are_written) {
    const TemporaryDirectory directory;
    runModes(readCase(directory.write("case.yaml", beamText)), 2, [](const std::string&) {});
    const auto rows = tableRows(directory.read("postProcessing/case/modes.dat"));
    const double exact = std::pow(1.875104069 / 3, 2) * std::sqrt(2e8 / 1000.0 * 0.05 * 0.05 / 12);
    for (int k : {0, 1}) {
        EXPECT_NEAR(rows[k][1], exact, 1e-5 * exact); // degree 3, 8 elements
    }
    EXPECT_THAT(directory.read("results/caseModes.pvd"), HasSubstr("timestep=\"2\""));
}

TEST(SpatialBeamCase, results_show_the_axis_in_straight_pieces) {
    const std::unique_ptr<Body> body = makeBody(readText(beamText));
    OutputOptions options;
    options.subdivision = 2;
    const VtuMesh mesh = body->meshes(options)[0];
    const Eigen::MatrixXd points = body->positions(mesh.points);
    ASSERT_EQ(mesh.cellSize, 2);
    double length = 0;
    for (std::size_t k = 0; k < mesh.connectivity.size(); k += 2) {
        length += (points.col(mesh.connectivity[k + 1]) - points.col(mesh.connectivity[k])).norm();
    }
    EXPECT_NEAR(length, 3, 1e-13);
}

TEST(SpatialBeamCase, a_z_of_zero_makes_a_line_spatial) {
    const std::string flat = replaced(beamText, "[1, 2, 2]}", "[3, 0, 0]}");
    EXPECT_EQ(makeBody(readText(flat))->dimension(), 3);
    const std::string arc = replaced(cableText, cableText.substr(0, cableText.find("disc")),
                                     "geometry: {arc: {centre: [0, 0, 1], radius: 2, "
                                     "angles: [0, 150]}}\n");
    const auto read = std::get<BeamDescription>(readText(arc).structure);
    EXPECT_EQ(read.dimension, 3);
    EXPECT_NEAR(read.curve.point(0)[2], 1, 1e-15);
}

TEST(SpatialBeamCase, check_says_that_it_is_in_space) {
    EXPECT_THAT(checkCase(readText(beamText)),
                AllOf(HasSubstr("Euler-Bernoulli beam in space, linear strains"),
                      HasSubstr("33 unknowns, 5 of them fixed")));
}

TEST(SpatialBeamCase, what_has_no_meaning_in_space_is_refused) {
    const std::string force = "end: end, force: [\"2*t\", 0, \"-t\"]";
    EXPECT_THAT(mistake(replaced(beamText, force, "end: end, moment: 1")),
                HasSubstr("loads[0].moment: is not available in space"));
    EXPECT_THAT(mistake(replaced(beamText, force, "pressure: 1")),
                HasSubstr("loads[0].pressure: is not available in space"));
    EXPECT_THAT(mistake(replaced(beamText, force, "gravity: [0, -1]")),
                HasSubstr("loads[0].gravity: must have 3 values here, but has 2"));
    EXPECT_THAT(mistake(replaced(beamText, "0.05}", "0.05, width: 0.1}")),
                HasSubstr("model.width: 0.1 is not the thickness 0.05"));
    EXPECT_THAT(mistake(replaced(beamText, "0.05}", "0.05, section: planeStrain}")),
                HasSubstr("model.section: planeStrain is not available in space"));
    EXPECT_THAT(mistake(replaced(cableText, "fix: [x, y, z]", "fix: [x, y, z, rotation]")),
                HasSubstr("'rotation' is not allowed; allowed: x, y, z"));
    EXPECT_THAT(mistake(beamText + "coupling: {}\n"),
                HasSubstr("coupling: a line in space cannot be coupled"));
    EXPECT_THAT(mistake(replaced(beamText, "line: {from: [0, 0, 0], to: [1, 2, 2]}",
                                 "arc: {centre: [0, 0, 0], radius: 1, angles: [0, 90]}")),
                HasSubstr("a beam in space must be straight"));
}
