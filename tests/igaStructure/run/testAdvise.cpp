// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/beam/exampleBeamCase.hpp"
#include "igaStructure/kinematics/thinness.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using testing::HasSubstr;
using testing::Not;

namespace {

std::string adviceOn(const std::string& text) {
    return checkCase(readText(text));
}

// The example beam without its watch points, some of which lie outside of a variant.
std::string variantOfBeam(const std::string& from, const std::string& to) {
    const std::string text = exampleBeamText(from, to);
    return text.substr(0, text.find("output:"));
}

} // namespace

TEST(Advise, says_how_many_steps_the_lowest_periods_have) {
    // The flap as a beam bends with (1.875, 4.694)^2 sqrt(366.3 / 300) rad/s and
    // stretches with pi/2 sqrt(439560 / 300) rad/s.
    EXPECT_THAT(adviceOn(exampleBeamText()),
                HasSubstr("advice: the lowest natural periods are 1.617 s, 0.258 s, 0.1045 s: "
                          "162, 25.8, 10.4 time steps; the trapezoidal rule makes them longer by "
                          "0.013 %, 0.49 %, 3 %; steps below 0.0058 s resolve all of them\n"));
    EXPECT_THAT(adviceOn(exampleBeamText("step: 0.01", "step: 0.005")),
                HasSubstr("0.0031 %, 0.12 %, 0.75 %\n"));
    EXPECT_THAT(adviceOn(exampleBeamText("step: 0.01", "step: 0.1")),
                HasSubstr("16.2, 2.58, 1.04 time steps; the trapezoidal rule makes them longer by "
                          "1.3 %, 49 %, 301 %; the step is too large even for the first\n"));
    EXPECT_THAT(
        adviceOn(exampleBeamText("time: {step", "time: {scheme: static, step")),
        HasSubstr("a dynamic run resolves them with steps below 0.09 s, 0.014 s, 0.0058 s"));
}

TEST(Advise, structure_with_a_single_unknown_has_one_period) {
    // The height's component of a bilinear function's corner: stiffness C a/(3 b) + G b/(3 a),
    // C = E (1 - nu)/((1 + nu)(1 - 2 nu)), a = 0.1, b = 1, and mass 300/9.
    std::string text = exampleText("  degree: [2, 3]\n  elements: [1, 8]\n",
                                   "  degree: [1, 1]\n  elements: [1, 1]\n");
    const std::string support = "  - {edge: bottom, fix: [x, y]}\n";
    text.insert(text.find(support), "  - {edge: top, fix: [x]}\n  - {edge: left, fix: [y]}\n");
    EXPECT_THAT(adviceOn(text), HasSubstr("the lowest natural periods are 0.01575 s: 1.57 time"));
}

TEST(Advise, asks_for_nonlinear_strains_where_displacements_are_large) {
    // Tip under the traction 100 y: 11/120 x 100 / 366.3 = 0.02503 m; ten times more.
    const std::string text = adviceOn(exampleBeamText("nonlinear", "linear"));
    EXPECT_THAT(text, HasSubstr("moves the structure by 0.025 m, 2.5 % of its size and 0.25 times "
                                "its thickness\n"));
    std::string large = exampleBeamText("nonlinear", "linear");
    large.replace(large.find("100*y"), 5, "1e3*y");
    EXPECT_THAT(adviceOn(large),
                HasSubstr("25 % of its size and 2.5 times its thickness; strains should be "
                          "nonlinear\n"));
    EXPECT_THAT(adviceOn(exampleBeamText("100*y", "0.1*y")), HasSubstr("linear strains would do"));
    // A tenth as thick under the thousandth load: 2.5 % of the size, but 2.5 thicknesses.
    std::string thin = variantOfBeam("nonlinear, thickness: 0.1", "linear, thickness: 0.01");
    thin.replace(thin.find("100*y"), 5, "0.1*y");
    EXPECT_THAT(adviceOn(thin), HasSubstr("2.5 times its thickness; strains should be nonlinear if "
                                          "ends or edges are held along the body"));
}

TEST(Advise, says_what_a_beam_of_this_slenderness_leaves_out) {
    EXPECT_THAT(
        adviceOn(exampleBeamText()),
        HasSubstr("slenderness (length over thickness) 10: shear deformation, which a beam "
                  "leaves out, would add about 0.78 % to a cantilever's deflection, and with "
                  "rotary inertia it makes the frequencies of the first three bending modes "
                  "about 0.79, 5.4 and 12 % too high; where a flow excites more than the "
                  "first of them, a plane solid is right\n"));
    EXPECT_THAT(adviceOn(exampleBeamText("thickness: 0.1", "thickness: 0.3")),
                HasSubstr("about 7 % to a cantilever's deflection; a plane solid models it"));
    EXPECT_THAT(adviceOn(exampleBeamText()), Not(HasSubstr("radius of curvature")));
    EXPECT_THAT(adviceOn(variantOfBeam("line: {from: [0, 0], to: [0, 1]}",
                                       "arc: {centre: [0, 0], radius: 0.5, angles: [0, 90]}")),
                HasSubstr("thickness over radius of curvature 0.2, terms of which order a beam "
                          "leaves out; a plane solid models them\n"));
}

TEST(Advise, second_frequency_of_a_beam_exceeds_that_of_a_plane_solid_as_told) {
    const auto second = [](const std::string& text) {
        return naturalModes(makeBody(readText(text))->model(), 2).angularFrequencies[1];
    };
    const double solid = second(exampleText("elements: [1, 8]", "elements: [2, 24]"));
    const double beam = second(exampleBeamText("elements: [8]", "elements: [24]"));
    // The estimate is of first order, and leaves out that a clamp also holds the fibres across
    // the axis: some tenths of a per cent.
    const double told = bendingOverestimate(10, 2);
    EXPECT_NEAR(beam / solid - 1, told, 0.2 * told);
}

TEST(Advise, slender_solid_could_be_a_beam) {
    EXPECT_THAT(adviceOn(exampleText()), HasSubstr("slenderness (size over mean thickness) 10\n"));
    EXPECT_THAT(
        adviceOn(exampleText("origin: [-0.05, 0], size: [0.1, 1]",
                             "origin: [-0.02, 0], size: [0.04, 1]")),
        HasSubstr("mean thickness) 25: a beam has the same slow motion with far fewer unknowns; "
                  "the frequency of its second bending mode is about 0.89 % higher\n"));
}

TEST(Advise, cable_is_told_where_bending_would_matter) {
    std::string text = variantOfBeam("kinematics: beam, strains: nonlinear, thickness: 0.1",
                                     "kinematics: cable, strains: nonlinear, thickness: 0.01, "
                                     "prestress: 3e4");
    text.replace(text.find("[x, y, rotation]"), 16, "[x, y]");
    text.replace(text.find("supports:\n"), 10, "supports:\n  - {end: end, fix: [x, y]}\n");
    // 0.01 sqrt(4e6 / (12 x 3e4)) m
    EXPECT_THAT(adviceOn(text),
                HasSubstr("slenderness (length over thickness) 100; bending stiffness, which it "
                          "leaves out, would matter within 0.033 m of its supports\n"));
}

TEST(Advise, says_which_fluid_resists_as_much_as_the_structure) {
    // 300 kg/m^2 and a half wave of 1 m: 300 pi / 2. The slowest motion's stiffness is
    // 3.516^2 E I per metre; times beta dt^2 (beta 0.3086 of spectral radius 0.8) that is
    // 0.14 kg/m^2.
    const std::string text = adviceOn(exampleBeamText() + "coupling: {}\n");
    EXPECT_THAT(text, HasSubstr("the structure has 300 kg on a square metre of interface, and in "
                                "its slowest motion a stiffness of 4528 Pa/m, which in a time step "
                                "of 0.01 s resists as 0.14 kg/m^2 do; a fluid of 471 kg/m^3 on "
                                "both sides, or of 943 kg/m^3 on one, adds as much to its slowest "
                                "motion: explicit"));
    EXPECT_THAT(adviceOn(exampleText() + "coupling: {interface: [left, top, right]}\n"),
                HasSubstr("the structure has 300 kg on a square metre of interface, and"));
    // Water in a layer of 2/pi m: sqrt(2000 / (pi 4528)) s.
    EXPECT_THAT(adviceOn(exampleBeamText("time: {step: 0.01, end: 0.1}", "time: {scheme: static}") +
                         "coupling: {}\n"),
                HasSubstr("water (1000 kg/m^3) on both sides resists as much in time steps of 0.37 "
                          "s, on one side of 0.27 s: explicit coupling needs much larger ones\n"));
}

TEST(Advise, says_that_the_cavitys_floor_is_stiffened_by_tension) {
    // Clamped at both ends: a period of 2 pi / 22.37 sqrt(m L^4 / E I) = 688 s at rest. The
    // deflection w of Duffing's beam: 1 + (w / t)^2 (E A / 2 L) (integral of w'^2) is more than
    // half as stiff again at its thickness.
    std::string text = "geometry: {line: {from: [0, 0], to: [1, 0]}}\n"
                       "discretisation: {degree: [3], elements: [8]}\n"
                       "model: {kinematics: beam, strains: nonlinear, thickness: 0.002}\n"
                       "supports:\n"
                       "  - {end: start, fix: [x, y, rotation]}\n"
                       "  - {end: end, fix: [x, y, rotation]}\n"
                       "material: {type: StVenantKirchhoff, youngsModulus: 250, poissonsRatio: 0, "
                       "density: 500}\n"
                       "time: {}\ncoupling: {}\n";
    EXPECT_THAT(adviceOn(text), HasSubstr("the lowest natural periods are 687.8 s"));
    EXPECT_THAT(adviceOn(text), HasSubstr("moved by its thickness of 0.002 m it is 1."));
    // No conclusion is drawn from what is true at rest only.
    EXPECT_THAT(adviceOn(text), Not(HasSubstr("resolves them with steps below")));
    EXPECT_THAT(adviceOn(text), HasSubstr("and at rest in its slowest motion a stiffness of"));
    text.replace(text.find("  - {end: end, fix: [x, y, rotation]}\n"), 38, "");
    EXPECT_THAT(adviceOn(text), Not(HasSubstr("moved by its thickness"))); // a cantilever
}

TEST(Advise, thickness_of_a_nanometre_is_in_no_range) {
    EXPECT_THAT(adviceOn(variantOfBeam("thickness: 0.1", "thickness: 1e-9")),
                HasSubstr("check the unit of the thickness"));
    const std::string shell =
        "geometry: {plate: {origin: [0, 0, 0], edgeXi: [1, 0, 0], edgeEta: [0, 1, 0]}}\n"
        "discretisation: {degree: [2, 2], elements: [2, 2]}\n"
        "model: {kinematics: shell, strains: linear, thickness: 1e-9}\n"
        "material: {type: StVenantKirchhoff, youngsModulus: 1e6, poissonsRatio: 0.3, "
        "density: 1000}\n"
        "supports: [{edge: left, fix: [x, y, z, rotation]}]\ntime: {step: 1, end: 1}\n";
    EXPECT_THAT(adviceOn(shell), HasSubstr("check the unit of the thickness"));
    EXPECT_THAT(adviceOn(shell), Not(HasSubstr("in the range")));
}

TEST(Advise, structure_with_free_rigid_motions_gets_no_estimate_of_stiffness) {
    const std::string text = adviceOn(exampleText("fix: [x, y]", "fix: [y]"));
    EXPECT_THAT(text, Not(HasSubstr("static estimate")));
    EXPECT_THAT(text, Not(HasSubstr("natural periods")));
    EXPECT_THAT(text, HasSubstr("warning: supports do not prevent"));
}
