// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace tokay;
using namespace tokay::structure;

// The structural benchmarks of Turek & Hron 2006: a flag under gravity, its
// root the cylinder's arc. Values: reference/turekHron.csv [mm].
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto place = text.find(from);
    if (place == std::string::npos) {
        throw std::logic_error("the case has no '" + from + "'");
    }
    return text.replace(place, from.size(), to);
}

std::string csm1() {
    std::ifstream file(TOKAY_SOURCE_DIR "/tests/igaStructure/cases/csm1.yaml");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// Rows time, ux, uy of point A [s, mm, mm].
std::vector<std::vector<double>> motionOfA(const std::string& text) {
    const TemporaryDirectory directory;
    runAlone(readCase(directory.write("case.yaml", text)), [](const std::string&) {});
    auto rows = tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
    for (std::vector<double>& row : rows) {
        row[1] *= 1000;
        row[2] *= 1000;
    }
    return rows;
}

} // namespace

TEST(TurekHron, CSM1_and_CSM2_agree_with_the_published_values) {
    const auto soft = motionOfA(csm1());
    EXPECT_NEAR(soft.back()[1], -7.187, 0.002 * 7.187);
    EXPECT_NEAR(soft.back()[2], -66.10, 0.002 * 66.10);
    const auto stiff = motionOfA(replaced(csm1(), "1.4e6", "5.6e6"));
    EXPECT_NEAR(stiff.back()[1], -0.4690, 0.002 * 0.4690);
    EXPECT_NEAR(stiff.back()[2], -16.97, 0.002 * 16.97);
}

TEST(TurekHron, CSM3_swings_as_published) {
    std::string text = replaced(csm1(), "scheme: static", "spectralRadius: 1");
    text = replaced(text, "step: 0.25", "step: 0.005");
    text = replaced(text, "end: 1", "end: 2");
    text = replaced(text, "-2*t", "-2");
    text = replaced(text, "[60, 6]", "[20, 2]");
    const auto rows = motionOfA(text);
    for (int c : {1, 2}) {
        const auto [low, high] = std::minmax_element(
            rows.begin(), rows.end(), [c](const auto& a, const auto& b) { return a[c] < b[c]; });
        const double mean = 0.5 * ((*low)[c] + (*high)[c]);
        const double amplitude = 0.5 * ((*high)[c] - (*low)[c]);
        // Published with a time step of 0.005 and another scheme: 2 %.
        EXPECT_NEAR(mean, c == 1 ? -14.305 : -63.607, 0.02 * std::abs(mean));
        EXPECT_NEAR(amplitude, c == 1 ? 14.305 : 65.160, 0.02 * amplitude);
    }
    std::vector<double> crossings; // of the mean, downwards
    for (std::size_t k = 1; k < rows.size(); ++k) {
        if (rows[k - 1][2] > -63.607 && rows[k][2] <= -63.607) {
            crossings.push_back(rows[k][0]);
        }
    }
    ASSERT_EQ(crossings.size(), 2u);
    // Each crossing is known to a step.
    EXPECT_NEAR(crossings[1] - crossings[0], 1 / 1.0995, 2 * 0.005);
}
