// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/MappingReport.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "sampleMeshes.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <limits>

namespace tokay::mapper {

TEST(MappingReport, as_json_reads_back_to_the_same_numbers) {
    const SurfaceMesh from = flatMesh(6, 4, FaceKind::quadrilaterals, ValuesAt::faces);
    const SurfaceMesh to = flatMesh(3, 3, FaceKind::triangles, ValuesAt::vertices);
    const MappingReport report = MortarMapping(from, to).report();
    const YAML::Node read = YAML::Load(report.json().text());
    EXPECT_EQ(read["method"].as<std::string>(), report.method);
    EXPECT_EQ(read["nPoints"].as<int>(), report.nPoints);
    EXPECT_EQ(read["nUnmatched"].as<int>(), 0);
    EXPECT_EQ(read["nAmbiguous"].as<int>(), 0);
    EXPECT_EQ(read["coverage"].as<double>(), report.coverage);
    EXPECT_EQ(read["largestGap_m"].as<double>(), report.largestGap);
    EXPECT_EQ(read["rowSumError"].as<double>(), report.rowSumError);
    EXPECT_EQ(read["forceSumError"].as<double>(), report.forceSumError);
    EXPECT_EQ(read["momentError"].as<double>(), report.momentError);
    EXPECT_EQ(read["nInverted"].as<int>(), 16);
    EXPECT_EQ(read["rank"].as<int>(), 16);
    EXPECT_EQ(read["condition"].as<double>(), report.condition);
    EXPECT_EQ(read["build_s"].as<double>(), report.seconds);
    EXPECT_EQ(read["memory_byte"].as<double>(), report.bytes);
    EXPECT_EQ(read["regularisation"].as<std::string>(), "");
    EXPECT_GT(report.condition, 1);
}

TEST(MappingReport, as_json_says_null_where_a_number_is_not_finite) {
    MappingReport report;
    report.condition = std::numeric_limits<double>::infinity();
    report.method = "a \"quoted\"\\name\n";
    const YAML::Node read = YAML::Load(report.json().text());
    EXPECT_TRUE(read["condition"].IsNull());
    EXPECT_EQ(read["method"].as<std::string>(), report.method);
}

TEST(MappingReport, text_names_what_is_uncovered_or_left_open) {
    MappingReport report;
    report.coverage = 0.25;
    report.nUncovered = 1;
    report.nInverted = 12;
    report.rank = 4;
    report.regularisation = "minimum norm";
    const std::string text = report.text();
    for (const char* part :
         {"coverage 25.0 %", "get nothing: 1\n", "12 x 12, rank 4 (singular)", "minimum norm"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in: " << text;
    }
    report.nUncovered = 0;
    report.rank = 12;
    report.regularisation.clear();
    for (const char* part : {"get nothing", "singular", "minimum norm"}) {
        EXPECT_EQ(report.text().find(part), std::string::npos) << part;
    }
}

} // namespace tokay::mapper
