// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/MappingReport.hpp"
#include "mapper/RowSparseMatrix.hpp"
#include "mapper/Stopwatch.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/offset/OffsetMapping.hpp"
#include "mapper/rbf/RbfMapping.hpp"
#include "sampleInterfaces.hpp"
#include "sampleMeshes.hpp"
#include "samplePatches.hpp"

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

namespace {

/// A report in which no two figures are equal.
MappingReport distinctFigures() {
    MappingReport report;
    report.method = "any";
    report.nPoints = 70;
    report.nUnmatched = 2;
    report.nAmbiguous = 3;
    report.coverage = 0.25;
    report.largestGap = 0.5;
    report.worstPoint = 4;
    report.relativeGap = 0.125;
    report.rowSumError = 1e-1;
    report.forceSumError = 2e-2;
    report.momentError = 3e-3;
    report.nUncovered = 5;
    report.nInverted = 12;
    report.rank = 11;
    report.condition = 800;
    report.seconds = 1.5;
    report.bytes = 6e6;
    return report;
}

} // namespace

TEST(MappingReport, as_text_has_each_figure_in_its_place) {
    const MappingReport report = distinctFigures();
    EXPECT_EQ(report.text(), "mapping: any\n"
                             "  points 70 (unmatched 2, ambiguous 3), coverage 25.0 %\n"
                             "  largest gap 0.5 m (0.125 of the interface size) at point 4\n"
                             "  errors: constant 1.0e-01, force sum 2.0e-02, moment 3.0e-03\n"
                             "  destination values that get nothing: 5\n"
                             "  mass matrix 12 x 12, rank 11 (singular), condition on the range "
                             "800\n"
                             "  built in 1.5 s, 6 MB\n");
}

TEST(MappingReport, as_json_has_each_figure_by_its_name) {
    const MappingReport report = distinctFigures();
    const YAML::Node read = YAML::Load(report.json().text());
    const std::pair<const char*, double> figures[] = {
        {"nPoints", 70},   {"nUnmatched", 2},       {"nAmbiguous", 3},      {"coverage", 0.25},
        {"worstPoint", 4}, {"largestGap_m", 0.5},   {"relativeGap", 0.125}, {"rowSumError", 1e-1},
        {"nUncovered", 5}, {"forceSumError", 2e-2}, {"momentError", 3e-3},  {"nInverted", 12},
        {"rank", 11},      {"condition", 800},      {"build_s", 1.5},       {"memory_byte", 6e6}};
    for (const auto& [name, value] : figures) {
        EXPECT_EQ(read[name].as<double>(), value) << name;
    }
}

TEST(MappingReport, time_to_build_is_that_of_the_constructor) {
    const Points to = flapPoints(9);
    const SurfaceMesh mesh = flatMesh(5, 4, FaceKind::triangles, ValuesAt::vertices);
    const auto expectTime = [](const auto& make) {
        const Stopwatch watch;
        const double seconds = make().report().seconds;
        EXPECT_GT(seconds, 0);
        EXPECT_LE(seconds, watch.seconds());
    };
    const SplineInterface flap = flapInterface(), axis = verticalSpline(2, 4);
    const SurfaceInterface patch = onePatch(geometry::TrimmedPatch(plate(3, 2)));
    expectTime([&] { return NearestElementMapping(flap, to); });
    expectTime([&] { return OffsetMapping(axis, to); });
    expectTime([&] { return OffsetMapping(patch, mesh.coordinates()); });
    expectTime([&] { return MortarMapping(mesh, patch); });
    expectTime([&] { return RbfMapping(mesh.coordinates(), mesh.coordinates()); });
}

TEST(MappingReport, memory_is_that_of_the_matrices_entries) {
    // A row of a compressed matrix has an offset, an entry of it a number and a column.
    constexpr double perRow = sizeof(int), perEntry = sizeof(double) + sizeof(int);
    const SurfaceMesh mesh = flatMesh(5, 4, FaceKind::triangles, ValuesAt::vertices);
    const Points points = mesh.coordinates();
    const double n = static_cast<double>(points.rows());
    // One neighbour each.
    EXPECT_EQ(NearestElementMapping(PointCloud(points), points).report().bytes,
              n * (perRow + perEntry) + perRow);
    // A beam of degree 3 and one element: functions, their derivatives and zeros at four control
    // points, whose numbers all points share.
    Points beside = flapPoints(5);
    EXPECT_EQ(OffsetMapping(verticalSpline(3, 1), beside).report().bytes,
              static_cast<double>(beside.rows()) * 4 * 3 * sizeof(double) + 4 * sizeof(int));
    const MortarMapping mortar(mesh, flatMesh(3, 3, FaceKind::triangles, ValuesAt::vertices));
    const double nEntries =
        static_cast<double>(mortar.massMatrix().nonZeros() + mortar.crossMatrix().nonZeros());
    EXPECT_NEAR(mortar.report().bytes, nEntries * perEntry, 3 * (16 + 1) * perRow);
    // A dense matrix between 30 points at least.
    EXPECT_GE(RbfMapping(points, points).report().bytes, sizeof(double) * n * n);
}

} // namespace tokay::mapper
