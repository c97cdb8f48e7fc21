// SPDX-License-Identifier: GPL-3.0-or-later
#include "GivenSolution.hpp"
#include "channel/connectedPair.hpp"
#include "common/errors.hpp"
#include "coupling/fixedPoint/Aitken.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tokay::coupling {
namespace {

using channel::errorOf;
using Eigen::VectorXd;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const CouplingOptions& options) {
    return errorOf<InputError>([&] { requireValid(options); });
}

/// Every number of the options, inside maps and with the chosen method's own.
std::vector<std::pair<const Entry*, Slot>> numbersOf(const Schema& schema, void* options) {
    std::vector<std::pair<const Entry*, Slot>> numbers;
    for (const Entry* entry : schema.entriesOf(options)) {
        const Slot slot = entry->slot(options);
        if (const auto* section = std::get_if<Section>(&slot)) {
            for (const auto& number : numbersOf(*section->schema, section->options)) {
                numbers.push_back(number);
            }
        } else if (std::holds_alternative<double*>(slot) || std::holds_alternative<int*>(slot)) {
            numbers.emplace_back(entry, slot);
        }
    }
    return numbers;
}

class EveryMethod : public testing::TestWithParam<CouplingMethodType> {
  protected:
    EveryMethod() { options.acceleration.type = GetParam().name; }
    CouplingOptions options;
};

TEST_P(EveryMethod, has_valid_defaults) {
    EXPECT_EQ(refusal(options), "");
}

TEST_P(EveryMethod, refuses_numbers_out_of_the_range_that_the_manual_states) {
    for (const auto& [entry, slot] : numbersOf(couplingSchema(), &options)) {
        ASSERT_NE(entry->range.text(), "") << entry->name;
        if (const auto* integer = std::get_if<int*>(&slot)) {
            const int valid = **integer;
            **integer = -1;
            EXPECT_THAT(refusal(options), HasSubstr(entry->name + ": -1 is out of range; allowed"));
            **integer = valid;
            continue;
        }
        double& number = *std::get<double*>(slot);
        const double valid = number;
        for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
            number = wrong;
            EXPECT_THAT(refusal(options),
                        AllOf(HasSubstr(entry->name), HasSubstr(entry->range.text())))
                << wrong;
        }
        number = valid;
    }
    EXPECT_EQ(refusal(options), "");
}

INSTANTIATE_TEST_SUITE_P(CouplingOptions, EveryMethod, testing::ValuesIn(couplingMethods()),
                         [](const auto& of) { return of.param.name; });

TEST(CouplingOptions, max_rank_must_leave_something_to_compress) {
    CouplingOptions options;
    for (const auto& [entry, slot] : numbersOf(couplingSchema(), &options)) {
        if (entry->name == "maxRank") {
            *std::get<int*>(slot) = 1;
        }
    }
    EXPECT_EQ(refusal(options), "maxRank: 1 is out of range; allowed: [2, inf)");
}

TEST(CouplingOptions, bounds_of_aitkens_factor_must_not_cross) {
    CouplingOptions options;
    options.acceleration.type = "aitken";
    options.acceleration.of<Aitken::Options>().maxRelaxation = 0.001;
    EXPECT_EQ(refusal(options), "maxRelaxation: 0.001 is below minRelaxation, which is 0.01");
}

TEST(CouplingOptions, a_method_that_does_not_exist_is_refused_with_those_that_do) {
    CouplingOptions options;
    options.acceleration.type = "newton";
    EXPECT_THAT(
        refusal(options),
        HasSubstr("acceleration.type: there is no 'newton'; allowed: explicit, constant, "));
}

TEST(CouplingOptions, are_checked_where_a_method_is_made) {
    CouplingOptions options;
    options.acceleration.type = "aitken";
    options.acceleration.of<Aitken::Options>().initialRelaxation = 2.5;
    EXPECT_THAT(errorOf<InputError>([&] { GivenSolution(options, 1e-6, VectorXd::Zero(1)); }),
                HasSubstr("initialRelaxation: 2.5 is out of range; allowed: (0, 2]"));
}

} // namespace
} // namespace tokay::coupling
