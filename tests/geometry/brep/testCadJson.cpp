// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJson.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleLoops.hpp"
#include "geometry/sampleModels.hpp"
#include "geometry/trimming/PatchQuadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace tokay::geometry {

namespace {

std::string pathOf(const std::string& name) {
    return testing::TempDir() + "tokayCadJson_" + name + ".cad.json";
}

std::string written(const std::string& name, const std::string& text) {
    const std::string path = pathOf(name);
    std::ofstream(path) << text;
    return path;
}

std::string contents(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::string straight(int trim, const char* range, const char* from, const char* to) {
    const std::string r = range;
    return "{\"trim_index\": " + std::to_string(trim) +
           ", \"curve_direction\": true,\n\t\"parameter_curve\": {\"is_rational\": false, "
           "\"degree\": 1, \"knot_vector\": [0, 0, " +
           r + ", " + r + "], \"active_range\": [0, " + r + "], \"control_points\": [[1, [" + from +
           ", 0, 1]], [2, [" + to + ", 0, 1]]]}}";
}

std::string face(int id, int firstTrim, const char* x0, const char* x1) {
    return "{\"brep_id\": " + std::to_string(id) +
           ", \"swapped_surface_normal\": false,\n\"surface\": {\"is_trimmed\": true, "
           "\"is_rational\": false, \"degrees\": [1, 1], \"knot_vectors\": [[0, 0, 6, 6], [0, 0, "
           "4, 4]],\n\"control_points\": [[1, [" +
           x0 + ", 0, 0, 1]], [2, [" + x1 + ", 0, 0, 1]], [3, [" + x0 + ", 4, 0, 1]], [4, [" + x1 +
           ", 4, 0, 1]]]},\n\"boundary_loops\": [{\"loop_type\": \"outer\", \"trimming_curves\": "
           "[\n" +
           straight(firstTrim, "6", "0, 0", "6, 0") + ",\n" +
           straight(firstTrim + 1, "4", "6, 0", "6, 4") + ",\n" +
           straight(firstTrim + 2, "6", "6, 4", "0, 4") + ",\n" +
           straight(firstTrim + 3, "4", "0, 4", "0, 0") +
           "]}],\n\"embedded_loops\": [], \"embedded_edges\": [], \"embedded_points\": []}";
}

/// Two plates that meet, as Kratos' own tests have them.
std::string twoPlates() {
    return "{\"tolerances\": {\"model_tolerance\": 0.001}, \"version_number\": 1, "
           "\"breps\": [{\"brep_id\": 4,\n\"faces\": [" +
           face(1, 0, "0", "6") + ",\n" + face(2, 4, "6", "12") +
           "],\n\"edges\": [{\"brep_id\": 6, \"topology\": [{\"brep_id\": 1, \"trim_index\": 1, "
           "\"relative_direction\": true}, {\"brep_id\": 2, \"trim_index\": 7, "
           "\"relative_direction\": false}]}],\n\"vertices\": []}]}\n";
}

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), fresh);
}

double modelArea(const BrepModel& model) {
    double sum = 0;
    for (const BrepFace& f : model.faces()) {
        sum += area(PatchQuadrature(f.patch));
    }
    return sum;
}

void expectSameCurve(const NurbsCurve& a, const NurbsCurve& b) {
    EXPECT_EQ(a.knotVector().knots(), b.knotVector().knots());
    EXPECT_EQ(a.controlPoints(), b.controlPoints());
    EXPECT_EQ(a.weights(), b.weights());
}

void expectSame(const BrepModel& a, const BrepModel& b) {
    EXPECT_EQ(a.tolerance(), b.tolerance());
    ASSERT_EQ(a.faces().size(), b.faces().size());
    for (int f = 0; f < static_cast<int>(a.faces().size()); ++f) {
        EXPECT_EQ(a.patch(f).name(), b.patch(f).name());
        EXPECT_EQ(a.faces()[f].isNormalSwapped, b.faces()[f].isNormalSwapped);
        EXPECT_EQ(a.patch(f).surface().u().knots(), b.patch(f).surface().u().knots());
        EXPECT_EQ(a.patch(f).surface().v().knots(), b.patch(f).surface().v().knots());
        EXPECT_EQ(a.patch(f).surface().controlPoints(), b.patch(f).surface().controlPoints());
        EXPECT_EQ(a.patch(f).surface().weights(), b.patch(f).surface().weights());
        ASSERT_EQ(a.patch(f).loops().size(), b.patch(f).loops().size());
        for (std::size_t l = 0; l < a.patch(f).loops().size(); ++l) {
            EXPECT_EQ(a.patch(f).loops()[l].kind(), b.patch(f).loops()[l].kind());
        }
        ASSERT_EQ(a.nCurves(f), b.nCurves(f));
        for (int c = 0; c < a.nCurves(f); ++c) {
            expectSameCurve(a.curve(f, c), b.curve(f, c));
        }
    }
    ASSERT_EQ(a.edges().size(), b.edges().size());
    for (std::size_t e = 0; e < a.edges().size(); ++e) {
        EXPECT_EQ(a.edges()[e].name, b.edges()[e].name);
        ASSERT_EQ(a.edges()[e].trims.size(), b.edges()[e].trims.size());
        for (std::size_t t = 0; t < a.edges()[e].trims.size(); ++t) {
            EXPECT_EQ(a.edges()[e].trims[t].face, b.edges()[e].trims[t].face);
            EXPECT_EQ(a.edges()[e].trims[t].curve, b.edges()[e].trims[t].curve);
            EXPECT_EQ(a.edges()[e].trims[t].isForward, b.edges()[e].trims[t].isForward);
        }
        ASSERT_EQ(a.edges()[e].curve.has_value(), b.edges()[e].curve.has_value());
        if (a.edges()[e].curve) {
            expectSameCurve(*a.edges()[e].curve, *b.edges()[e].curve);
        }
    }
}

void expectRefused(const std::string& old, const std::string& fresh,
                   const std::vector<std::string>& words) {
    const std::string path = written("malformed", replaced(twoPlates(), old, fresh));
    std::vector<std::string> all = words;
    all.push_back(path + ":");
    expectInputError([&] { readCadJson(path); }, all);
}

} // namespace

TEST(CadJson, readsFacesLoopsAndEdges) {
    const CadJson read = readCadJson(written("twoPlates", twoPlates()));
    EXPECT_TRUE(read.notes.empty());
    EXPECT_EQ(read.model.tolerance(), 0.001);
    ASSERT_EQ(read.model.faces().size(), 2u);
    EXPECT_EQ(read.model.faceNumber("2"), 1);
    EXPECT_NEAR(modelArea(read.model), 48, 1e-13);
    ASSERT_EQ(read.model.gaps().size(), 1u);
    EXPECT_LT(read.model.gaps()[0].distance, 1e-14);
    const BrepEdge& edge = read.model.edges()[read.model.edgeNumber("6")];
    EXPECT_EQ(edge.trims[1].curve, 3);
    EXPECT_FALSE(edge.trims[1].isForward);
}

TEST(CadJson, whatIsWrittenIsReadToTheBit) {
    const double pi = std::acos(-1.0);
    std::vector<BrepFace> faces = twoSquares().faces();
    faces.push_back({TrimmedPatch(cylinderPatch(Point(0.1, 0.2, 1.0 / 3), 0.7, 2, 0, 2 * pi),
                                  {circleLoop(LoopKind::inner, {0.3, 0.4}, 0.1)}, "17")});
    faces[0].embeddedCurves.push_back(line(Point(0.1, 0.1, 0), Point(0.2, 0.9, 0)));
    std::vector<BrepEdge> edges = coincidentEdges(faces, 1e-9);
    edges[0].curve = arc(Point(1, 2, 3), 4, 0.1, 0.7);
    edges[1].name = "a \"quoted\" name";
    edges.push_back({"embedded", {{0, 5}}});
    const BrepModel model(faces, edges, 1e-7);
    writeCadJson(model, pathOf("first"));
    const CadJson read = readCadJson(pathOf("first"));
    EXPECT_TRUE(read.notes.empty());
    expectSame(model, read.model);
    writeCadJson(read.model, pathOf("second"));
    EXPECT_EQ(contents(pathOf("first")), contents(pathOf("second")));
}

TEST(CadJson, curveDirectionAndActiveRangeAreFollowed) {
    // The bottom curve is given backwards and longer than it is used.
    const std::string bottom = straight(0, "6", "0, 0", "6, 0");
    std::string turned = straight(0, "6", "6, 0", "-6, 0");
    turned = replaced(turned, "\"curve_direction\": true", "\"curve_direction\": false");
    turned = replaced(turned, "\"active_range\": [0, 6]", "\"active_range\": [0, 3]");
    const CadJson read = readCadJson(written("turned", replaced(twoPlates(), bottom, turned)));
    EXPECT_NEAR(modelArea(read.model), 48, 1e-13);
    EXPECT_EQ(read.model.curve(0, 0).point(0), Point(0, 0, 0));
}

TEST(CadJson, periodicAndShortenedKnotVectorsAreRead) {
    const std::string shortened =
        replaced(replaced(twoPlates(), "[0, 0, 6, 6], [0, 0, 4, 4]", "[0, 6], [0, 4]"),
                 "\"knot_vector\": [0, 0, 6, 6]", "\"knot_vector\": [0, 6]");
    EXPECT_NEAR(modelArea(readCadJson(written("shortened", shortened)).model), 48, 1e-13);
    // The line from (0, 0) to (6, 0) as a part of a longer one.
    const std::string unclamped =
        replaced(twoPlates(), "\"knot_vector\": [0, 0, 6, 6]", "\"knot_vector\": [-7, 0, 6, 9]");
    EXPECT_NEAR(modelArea(readCadJson(written("unclamped", unclamped)).model), 48, 1e-13);
}

TEST(CadJson, aPeriodicSurfaceIsReadClosedAndSmooth) {
    // As CAD programs write a tube: control points repeat, outer knots are left out.
    const int n = 10;
    std::string points;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < n; ++i) {
            const double angle = std::acos(-1.0) / 4 * i;
            points += (points.empty() ? "[1, [" : ", [1, [") + std::to_string(std::cos(angle)) +
                      ", " + std::to_string(std::sin(angle)) + ", " + std::to_string(j) + ", 1]]";
        }
    }
    const std::string text =
        "{\"breps\": [{\"brep_id\": 1, \"faces\": [{\"brep_name\": \"tube\", \"surface\": "
        "{\"degrees\": [2, 1], \"knot_vectors\": [[-1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9], [0, 1]], "
        "\"control_points\": [" +
        points + "]}}]}]}";
    const BrepModel model = readCadJson(written("tube", text)).model;
    const NurbsSurface& tube = model.patch(model.faceNumber("tube")).surface();
    EXPECT_EQ(tube.u().first(), 0);
    EXPECT_EQ(tube.u().last(), 8);
    for (const double eta : {0.0, 0.4, 1.0}) {
        EXPECT_LT((tube.derivatives(0, eta, 1) - tube.derivatives(8, eta, 1)).norm(), 1e-14);
    }
    // Knots lie midway between control points.
    EXPECT_LT(
        (tube.point(3, 0.5) -
         Point(std::cos(1.0 * std::acos(-1.0) * 3.5 / 4), std::sin(std::acos(-1.0) * 3.5 / 4), 0) *
             std::cos(std::acos(-1.0) / 8) -
         Point(0, 0, 0.5))
            .norm(),
        1e-6); // the text has 6 decimals
}

TEST(CadJson, contradictingDirectionsAndUnusedVerticesAreNoted) {
    std::string text =
        replaced(twoPlates(), "\"relative_direction\": false", "\"relative_direction\": true");
    text = replaced(text, "\"vertices\": []", "\"vertices\": [{\"brep_id\": 9}]");
    const CadJson read = readCadJson(written("noted", text));
    ASSERT_EQ(read.notes.size(), 2u);
    EXPECT_NE(read.notes[0].find("1 vertices"), std::string::npos);
    EXPECT_NE(read.notes[1].find("edge \"6\""), std::string::npos);
    EXPECT_FALSE(read.model.edges()[0].trims[1].isForward);
}

TEST(CadJson, malformedFilesAreRefusedWithLineAndKey) {
    expectInputError([] { readCadJson("nowhere.cad.json"); }, {"nowhere.cad.json", "opened"});
    expectRefused("\"vertices\": []}]}", "\"vertices\": [}", {"not JSON"});
    expectRefused("\"breps\"", "\"brep\"", {"'breps' is missing"});
    expectRefused(
        "\"degrees\": [1, 1]", "\"degrees\": [1, 2]",
        {":3:", "breps[0].faces[0].surface", "4 control points", "need 2", "degrees 1 and 2"});
    expectRefused("\"degrees\": [1, 1]", "\"degrees\": [1, 1.5]",
                  {"breps[0].faces[0].surface.degrees[1]", "1.5", "integer"});
    expectRefused("[0, 0, 6, 6]", "[0, 6, 0, 6]", {"knot_vectors[0]", "knot 2", "0"});
    expectRefused("[2, [6, 0, 0, 1]]", "[2, [6, 0, 0]]",
                  {"control_points[1][1]", "4 numbers", "3"});
    expectRefused("[2, [6, 0, 0, 1]]", "[2, [6, nan, 0, 1]]",
                  {"control_points[1][1][1]", "nan", "number"});
    expectRefused("[2, [6, 0, 0, 1]]", "[2, [6, 0, 0, -1]]", {"weight is -1", "positive"});
    expectRefused("[2, [6, 0, 0, 1]]", "[2, [6, 0, 0, 2]]", {"weight is 2", "is_rational"});
    expectRefused("\"outer\"", "\"outside\"", {"loop_type", "outside", "outer or inner"});
    expectRefused("\"outer\"", "\"inner\"", {"boundary_loops[0]", "counter-clockwise"});
    expectRefused("\"trim_index\": 1, \"relative", "\"trim_index\": 9, \"relative",
                  {"topology[0].trim_index", "no curve of trim_index 9"});
    expectRefused("{\"brep_id\": 2, \"trim_index\"", "{\"brep_id\": 3, \"trim_index\"",
                  {"topology[1]", "no face \"3\""});
    expectRefused("\"trim_index\": 1, \"curve", "\"trim_index\": 0, \"curve",
                  {"trimming_curves[1]", "trim_index 0 occurs twice"});
    expectRefused("\"curve_direction\": true", "\"curve_direction\": 1",
                  {"curve_direction", "true or false"});
    expectRefused("\"active_range\": [0, 6]", "\"active_range\": [0, 7]",
                  {"active_range", "0 to 6", "0 to 7"});
    expectRefused("\"active_range\": [0, 6]", "\"active_range\": [0, 5]",
                  {"boundary_loops[0]", "open", "(5, 0)"});
}

} // namespace tokay::geometry
