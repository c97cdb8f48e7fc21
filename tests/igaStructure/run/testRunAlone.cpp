// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/OutputFile.hpp"
#include "common/errors.hpp"
#include "fileSizeLimit.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

using namespace tokay;
using namespace tokay::structure;
using testing::HasSubstr;
using testing::Not;

namespace {

std::vector<std::string> runText(const TemporaryDirectory& directory, const std::string& text) {
    std::vector<std::string> log;
    runAlone(readCase(directory.write("case.yaml", text)),
             [&](const std::string& line) { log.push_back(line); });
    return log;
}

} // namespace

// Traction 100 y on the left edge of the flap, 50 N in total. Published first
// peak of linear solids: reference/perpendicularFlap.csv, rows fake-*.
TEST(RunAlone, flap_under_the_fake_load_swings_as_published) {
    for (const char* elements : {"[2, 12]", "[4, 24]"}) {
        std::string text = exampleText("[1, 8]", elements);
        text.replace(text.find("end: 0.1"), 8, "end: 1.0");
        const TemporaryDirectory directory;
        runText(directory, text);
        const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
        ASSERT_EQ(rows.size(), 100u);
        const auto peak = *std::max_element(
            rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
        EXPECT_NEAR(peak[1], 0.0509, 0.01 * 0.0509) << elements;
        EXPECT_NEAR(peak[0], 0.82, 0.011) << elements; // a step beside the published one
    }
}

TEST(RunAlone, tells_one_line_a_step_with_tip_and_time_to_go) {
    const TemporaryDirectory directory;
    const std::vector<std::string> log = runText(directory, exampleText());
    ASSERT_EQ(log.size(), 11u); // the model and ten steps
    EXPECT_THAT(log[0], HasSubstr("degree 2 x 3, 1 x 8 elements"));
    EXPECT_THAT(log[10], HasSubstr("step 10 time 0.1 s  iterations 1 residual "));
    EXPECT_THAT(log[10], HasSubstr("tip ("));
    EXPECT_THAT(log[10], HasSubstr("s/step, 0 s to go"));
}

TEST(RunAlone, tables_have_one_row_a_step_and_a_header_with_units) {
    const TemporaryDirectory directory;
    runText(directory, exampleText());
    for (const char* table : {"watchPoints", "iterations", "energy"}) {
        const std::string text =
            directory.read(std::string("postProcessing/case/0/") + table + ".dat");
        EXPECT_EQ(text.rfind("# time[s] ", 0), 0u) << table;
        EXPECT_EQ(tableRows(text).size(), 10u) << table;
    }
}

TEST(RunAlone, results_come_at_the_interval_and_at_the_end) {
    const TemporaryDirectory directory;
    runText(directory, exampleText("output:", "output:\n  interval: 4"));
    const std::string pvd = directory.read("results/case.pvd");
    for (const char* time : {"\"0\"", "\"0.04\"", "\"0.08\"", "\"0.1\""}) {
        EXPECT_THAT(pvd, HasSubstr(std::string("timestep=") + time));
    }
    EXPECT_THAT(pvd, Not(HasSubstr("timestep=\"0.05\"")));
}

TEST(RunAlone, last_step_is_shortened_to_the_end) {
    const TemporaryDirectory directory;
    runText(directory, exampleText("end: 0.1", "end: 0.025"));
    const auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[2][0], 0.025);
}

TEST(RunAlone, energy_table_balances_with_the_trapezoidal_rule) {
    const TemporaryDirectory directory;
    runText(directory, exampleText("time:\n", "time:\n  scheme: newmark\n"));
    for (const auto& row : tableRows(directory.read("postProcessing/case/0/energy.dat"))) {
        EXPECT_NEAR(row[1] + row[2], row[3], 1e-9 * row[3]); // the table has 12 digits
    }
}

TEST(RunAlone, missing_time_step_is_reported) {
    const TemporaryDirectory directory;
    EXPECT_THROW(
        {
            try {
                runText(directory, exampleText("time:\n  step: 0.01\n  end: 0.1\n", ""));
            } catch (const InputError& error) {
                EXPECT_THAT(error.what(), HasSubstr("time: entries 'step' and 'end' are missing"));
                throw;
            }
        },
        InputError);
}

TEST(RunAlone, watch_point_beside_the_body_is_reported_with_the_nearest_place) {
    const TemporaryDirectory directory;
    try {
        runText(directory, exampleText("at: [0, 1]", "at: [0, 1.5]"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("output.watchPoints: 'tip' at [0, 1.5] lies 0.5 m "
                                            "outside the body; its nearest point is [0, 1]"));
    }
}

TEST(RunAlone, full_disk_ends_the_run_with_the_file_and_keeps_older_results) {
    const TemporaryDirectory directory;
    runText(directory, exampleText());
    const std::string older = directory.read("results/case.pvd");
    const std::string olderVtu = directory.read("results/case_00001.vtu");
    const FileSizeLimit limit(4096);
    try {
        runText(directory, exampleText());
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("results/case_0000"));
    }
    EXPECT_EQ(directory.read("results/case.pvd"), older);
    EXPECT_EQ(directory.read("results/case_00001.vtu"), olderVtu);
}

TEST(CheckCase, says_what_would_be_modelled_and_needed) {
    const std::string text = checkCase(readText(exampleText()));
    EXPECT_THAT(text, HasSubstr("plane strain, linear strains, degree 2 x 3, 1 x 8 elements"));
    EXPECT_THAT(text, HasSubstr("66 unknowns, 6 of them fixed"));
    EXPECT_THAT(text, HasSubstr("memory: "));
    EXPECT_THAT(text, HasSubstr("alone: to 0.1 s by steps of 0.01 s"));
    // Which linear algebra is installed is no matter of the case
    const std::regex ofMachine("warning: slow linear algebra.*\n");
    EXPECT_THAT(std::regex_replace(text, ofMachine, ""), Not(HasSubstr("warning")));
}

TEST(CheckCase, prints_all_options_of_the_chosen_acceleration) {
    const std::string text = checkCase(readText(exampleText(
        "output:", "coupling:\n  interface: [left, right]\n  acceleration: {type: iqnIls, "
                   "maxStep: 7}\noutput:")));
    EXPECT_THAT(text, HasSubstr("coupling: interface left right, displacements nearestElement, "
                                "loads integrated, gap limit 0.01"));
    EXPECT_THAT(
        text,
        HasSubstr("acceleration iqnIls, reusedTimeSteps 15, maxColumns 30, initialRelaxation 0.1"));
    EXPECT_THAT(text, HasSubstr("maxStep 7"));
    EXPECT_THAT(text, HasSubstr("filter qr2"));
}

TEST(CheckCase, warns_of_free_rigid_motions_and_of_steps_that_a_fluid_overrides) {
    EXPECT_THAT(checkCase(readText(exampleText("fix: [x, y]", "fix: [y]"))),
                HasSubstr("warning: supports do not prevent: translation along x"));
    EXPECT_THAT(
        checkCase(readText(exampleText("output:", "coupling: {interface: [left]}\noutput:"))),
        HasSubstr("note: a coupled run takes time steps and end from the fluid"));
    EXPECT_THAT(checkCase(readText(exampleText("time:\n  step: 0.01\n  end: 0.1\n", ""))),
                HasSubstr("warning: there is neither coupling nor time.step"));
}
