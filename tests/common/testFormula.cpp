// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Formula.hpp"
#include "geometry/expectInputError.hpp"

#include <gtest/gtest.h>

namespace tokay {

TEST(Formula, takesPlaceAndTime) {
    const Formula formula("x + 10*y + 100*z - t", "");
    EXPECT_EQ(formula({1, 2, 3}, 4), 317);
    const Formula copy = formula;
    EXPECT_EQ(copy({1, 0, 0}, 0), 1);
}

TEST(Formula, namesItsVariablesWhenOneIsUnknown) {
    expectInputError([] { Formula("x + w", "case.yaml:3: "); },
                     {"case.yaml:3: formula 'x + w'", "variables are x, y, z [m] and t [s]"});
}

TEST(Formula, saysWhereItsValueIsNotFinite) {
    expectInputError(
        [] {
            Formula("1/z", "")({1, 2, 0}, 0);
        },
        {"'1/z' gives inf", "x = 1, y = 2, z = 0"});
}

TEST(Formula, dependsOnTimeIfItUsesIt) {
    EXPECT_TRUE(Formula("sin(t)", "").dependsOnTime());
    EXPECT_FALSE(Formula("tan(x)", "").dependsOnTime());
}

} // namespace tokay
