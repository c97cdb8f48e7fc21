// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/timeIntegration/TimeOptions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using testing::HasSubstr;

namespace {

/// The example with these entries of `time`.
Case withTime(const std::string& entries) {
    return readText(exampleText("time:\n  step: 0.01\n  end: 0.1\n", "time: {" + entries + "}\n"));
}

std::string refusal(const std::string& entries) {
    try {
        withTime(entries);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST(TimeOptions, entries_reach_the_scheme) {
    const std::string run = "step: 0.01, end: 0.1, scheme: ";
    // Chung and Hulbert 1993: alphaF is the spectral radius over one plus it.
    EXPECT_NEAR(withTime(run + "generalisedAlpha, spectralRadius: 0.25").implicitScheme()->alphaF,
                0.2, 1e-15);
    EXPECT_NEAR(withTime("step: 0.01, end: 0.1").implicitScheme()->alphaF, 0.8 / 1.8, 1e-15);
    const Case newmark = withTime(run + "newmark, beta: 0.3, gamma: 0.6");
    EXPECT_EQ(newmark.implicitScheme()->beta, 0.3);
    EXPECT_EQ(newmark.implicitScheme()->gamma, 0.6);
    EXPECT_FALSE(withTime(run + "static").implicitScheme()->dynamic);
    const Case path = withTime(run + "arcLength, maxSteps: 7, maxGrowth: 3");
    EXPECT_EQ(std::get<EquilibriumPath>(path.timeScheme).maxSteps, 7);
    EXPECT_EQ(std::get<EquilibriumPath>(path.timeScheme).maxGrowth, 3);
    EXPECT_TRUE(std::holds_alternative<CentralDifferences>(withTime(run + "explicit").timeScheme));
}

TEST(TimeOptions, steps_that_fail_are_halved_only_if_the_file_says_how_far) {
    EXPECT_EQ(withTime("step: 0.01, end: 0.1").timeSteps->minDeltaT, 0.01);
    EXPECT_EQ(withTime("step: 0.01, end: 0.1, minDeltaT: 1e-4").timeSteps->minDeltaT, 1e-4);
    EXPECT_EQ(withTime("step: 0.01, end: 0.1, minDeltaT: 0.01").timeSteps->minDeltaT, 0.01);
    EXPECT_THAT(refusal("step: 0.01, end: 0.1, minDeltaT: 0.02"),
                HasSubstr("time.minDeltaT: 0.02 s is longer than the step of 0.01 s"));
}

TEST(TimeOptions, run_alone_needs_step_and_end_and_names_the_one_that_is_missing) {
    EXPECT_THAT(refusal("step: 0.01"), HasSubstr("time: entry 'end' is missing"));
    EXPECT_THAT(refusal("end: 0.1"), HasSubstr("time: entry 'step' is missing"));
}

TEST(TimeOptions, run_has_one_step_at_least_and_no_more_than_can_be_counted) {
    EXPECT_EQ(refusal("step: 0.1, end: 0.1"), "accepted");
    EXPECT_THAT(refusal("step: 0.1, end: 0.09"),
                HasSubstr("time.end: 0.09 s is shorter than one step of 0.1 s"));
    EXPECT_EQ(refusal("step: 1e-9, end: 2"), "accepted");
    EXPECT_THAT(refusal("step: 1e-9, end: 3"),
                HasSubstr("time.step: 1e-09 s makes 3e+09 time steps to the end at 3 s"));
    // The first step of a path is a unit of its arcs, not one of equal parts.
    EXPECT_EQ(refusal("step: 1e-9, end: 3, scheme: arcLength"), "accepted");
}
