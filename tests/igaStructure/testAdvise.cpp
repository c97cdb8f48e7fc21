#include "exampleBeamCase.hpp"
#include "exampleCase.hpp"
#include "igaStructure/run/checkCase.hpp"

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

} // namespace

TEST(Advise, says_how_many_steps_the_first_period_has) {
    // The flap: first frequency 3.516 sqrt(E I / m) = 3.516 sqrt(366.3 / 300) rad/s
    // as a beam, 1.617 s, 162 steps.
    const std::string text = adviceOn(exampleBeamText());
    EXPECT_THAT(text, HasSubstr("advice: the first natural period is 1.617 s, 162 time steps"));
    EXPECT_THAT(text, Not(HasSubstr("too large")));
    EXPECT_THAT(adviceOn(exampleBeamText("step: 0.01", "step: 0.1")),
                HasSubstr("16.2 time steps; the trapezoidal rule makes it longer by 1.3 %; the "
                          "step is too large for it"));
}

TEST(Advise, asks_for_nonlinear_strains_where_displacements_are_large) {
    // Tip under the traction 100 y: 11/120 x 100 / 366.3 = 0.02503 m; ten times more.
    const std::string text = adviceOn(exampleBeamText("nonlinear", "linear"));
    EXPECT_THAT(text, HasSubstr("moves the structure by 0.025 m, 2.5 % of its size\n"));
    std::string large = exampleBeamText("nonlinear", "linear");
    large.replace(large.find("100*y"), 5, "1e3*y");
    EXPECT_THAT(adviceOn(large), HasSubstr("25 % of its size; strains should be nonlinear"));
    EXPECT_THAT(adviceOn(exampleBeamText("100*y", "0.1*y")), HasSubstr("linear strains would do"));
}

TEST(Advise, says_what_a_beam_of_this_slenderness_leaves_out) {
    EXPECT_THAT(adviceOn(exampleBeamText()),
                HasSubstr("slenderness (length over thickness) 10: shear deformation, which a beam "
                          "leaves out, would add about 0.78 % to a cantilever's deflection\n"));
    EXPECT_THAT(adviceOn(exampleBeamText("thickness: 0.1", "thickness: 0.3")),
                HasSubstr("about 7 % to a cantilever's deflection; a plane solid models it"));
}

TEST(Advise, says_which_fluid_is_as_heavy_as_the_structure) {
    // 300 kg/m^2 and a half wave of 1 m: 300 pi / 2.
    for (const std::string& text :
         {exampleBeamText() + "coupling: {}\n",
          exampleText() + "coupling: {interface: [left, top, right]}\n"}) {
        EXPECT_THAT(adviceOn(text), HasSubstr("the structure has 300 kg on a square metre of "
                                              "interface; a fluid of 471 kg/m^3 on both sides"));
    }
}

TEST(Advise, structure_with_free_rigid_motions_gets_no_estimate_of_stiffness) {
    const std::string text = adviceOn(exampleText("fix: [x, y]", "fix: [y]"));
    EXPECT_THAT(text, Not(HasSubstr("advice")));
    EXPECT_THAT(text, HasSubstr("warning: supports do not prevent"));
}
