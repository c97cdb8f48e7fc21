// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Formula.hpp"
#include "common/errors.hpp"
#include "geometry/expectInputError.hpp"

#include <gtest/gtest.h>

namespace tokay {

TEST(Formula, takes_place_and_time) {
    const Formula formula("x + 10*y + 100*z - t", "");
    EXPECT_EQ(formula({1, 2, 3}, 4), 317);
    const Formula copy = formula;
    EXPECT_EQ(copy({1, 0, 0}, 0), 1);
}

TEST(Formula, names_its_variables_when_one_is_unknown) {
    expectInputError([] { Formula("x + w", "case.yaml:3: "); },
                     {"case.yaml:3: formula 'x + w'", "variables are x, y, z [m] and t [s]"});
}

TEST(Formula, says_where_its_value_is_not_finite) {
    expectInputError(
        [] {
            Formula("1/z", "")({1, 2, 0}, 0);
        },
        {"'1/z' gives inf", "x = 1, y = 2, z = 0"});
}

TEST(Formula, is_one_value_not_the_last_of_several_nor_an_assignment) {
    expectInputError([] { Formula("0,5*y", "case.yaml:3: "); },
                     {"case.yaml:3: formula '0,5*y' has 2 expressions", "0.5, not 0,5"});
    for (const char* assignment : {"x=3", "y*=2", "x==1 && y=2"}) {
        expectInputError([=] { Formula(assignment, "case.yaml:3: "); },
                         {"case.yaml:3: formula '", assignment, "assigns a value"});
    }
    // Comparisons, and commas between arguments, are none of these.
    EXPECT_EQ(Formula("x==1 && y>=2 && z<=3 && t!=1", "")({1, 2, 3}, 4), 1);
    EXPECT_EQ(Formula("max(x,5)", "")({1, 2, 3}, 4), 5);
}

TEST(Formula, of_twenty_thousand_characters_is_refused_in_a_short_message) {
    std::string sum = "x";
    while (sum.size() < 20000) {
        sum += "+x";
    }
    try {
        Formula(sum, "case.yaml:3: ");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.rfind("case.yaml:3: formula 'x+x+", 0), 0u) << message;
        EXPECT_NE(message.find("has 20001 characters; at most 4000"), std::string::npos) << message;
        EXPECT_LT(message.size(), 200u);
    }
}

TEST(Formula, depends_on_time_if_it_uses_it) {
    EXPECT_TRUE(Formula("sin(t)", "").dependsOnTime());
    EXPECT_FALSE(Formula("tan(x)", "").dependsOnTime());
}

} // namespace tokay
