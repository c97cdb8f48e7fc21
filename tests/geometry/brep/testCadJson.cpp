// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJson.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleLoops.hpp"
#include "geometry/sampleModels.hpp"
#include "geometry/spline/refinement.hpp"
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

TEST(CadJson, reads_faces_loops_and_edges) {
    const BrepModel read = readCadJson(written("twoPlates", twoPlates()));
    EXPECT_TRUE(read.remarks().empty());
    EXPECT_EQ(read.tolerance(), 0.001);
    ASSERT_EQ(read.faces().size(), 2u);
    EXPECT_EQ(read.faceNumber("2"), 1);
    EXPECT_NEAR(modelArea(read), 48, 1e-13);
    EXPECT_LT(largestGap(read, read.edges()[read.edgeNumber("6")]), 1e-14);
    const BrepEdge& edge = read.edges()[read.edgeNumber("6")];
    EXPECT_EQ(edge.trims[1].curve, 3);
    EXPECT_FALSE(edge.trims[1].isForward);
}

TEST(CadJson, what_is_written_is_read_to_the_bit) {
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
    const BrepModel read = readCadJson(pathOf("first"));
    EXPECT_TRUE(read.remarks().empty());
    expectSame(model, read);
    writeCadJson(read, pathOf("second"));
    EXPECT_EQ(contents(pathOf("first")), contents(pathOf("second")));
}

TEST(CadJson, curve_direction_and_active_range_are_followed) {
    // The bottom curve is given backwards and longer than it is used.
    const std::string bottom = straight(0, "6", "0, 0", "6, 0");
    std::string turned = straight(0, "6", "6, 0", "-6, 0");
    turned = replaced(turned, "\"curve_direction\": true", "\"curve_direction\": false");
    turned = replaced(turned, "\"active_range\": [0, 6]", "\"active_range\": [0, 3]");
    const BrepModel read = readCadJson(written("turned", replaced(twoPlates(), bottom, turned)));
    EXPECT_NEAR(modelArea(read), 48, 1e-13);
    EXPECT_EQ(read.curve(0, 0).point(0), Point(0, 0, 0));
}

TEST(CadJson, periodic_and_shortened_knot_vectors_are_read) {
    const std::string shortened =
        replaced(replaced(twoPlates(), "[0, 0, 6, 6], [0, 0, 4, 4]", "[0, 6], [0, 4]"),
                 "\"knot_vector\": [0, 0, 6, 6]", "\"knot_vector\": [0, 6]");
    EXPECT_NEAR(modelArea(readCadJson(written("shortened", shortened))), 48, 1e-13);
    // The line from (0, 0) to (6, 0) as a part of a longer one.
    const std::string unclamped =
        replaced(twoPlates(), "\"knot_vector\": [0, 0, 6, 6]", "\"knot_vector\": [-7, 0, 6, 9]");
    EXPECT_NEAR(modelArea(readCadJson(written("unclamped", unclamped))), 48, 1e-13);
}

TEST(CadJson, a_periodic_surface_is_read_closed_and_smooth) {
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
    const BrepModel model = readCadJson(written("tube", text));
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

TEST(CadJson, contradicting_directions_and_unused_vertices_are_remarked) {
    std::string text =
        replaced(twoPlates(), "\"relative_direction\": false", "\"relative_direction\": true");
    text = replaced(text, "\"vertices\": []", "\"vertices\": [{\"brep_id\": 9}]");
    const BrepModel read = readCadJson(written("remarked", text));
    ASSERT_EQ(read.remarks().size(), 2u);
    EXPECT_NE(read.remarks()[0].find("1 vertices"), std::string::npos);
    EXPECT_NE(read.remarks()[1].find("edge \"6\""), std::string::npos);
    EXPECT_FALSE(read.edges()[0].trims[1].isForward);
    EXPECT_EQ(withCoincidentEdges(read, 1e-9).remarks(), read.remarks());
}

TEST(CadJson, malformed_files_are_refused_with_line_and_key) {
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

TEST(CadJson, a_hole_whose_control_point_is_off_by_rounding_is_read) {
    // Two half circles, of which one leaves its joint 3e-12 of 100 beside the tangent.
    const auto half = [](double sign, double off) {
        Points points(5, 3);
        points << 3 - sign, 2, 0, 3 - sign + off, 2 + sign, 0, 3, 2 + sign, 0, 3 + sign, 2 + sign,
            0, 3 + sign, 2, 0;
        Eigen::VectorXd weights(5);
        weights << 1, std::sqrt(0.5), 1, std::sqrt(0.5), 1;
        return NurbsCurve(KnotVector(2, {0, 0, 0, 1, 1, 2, 2, 2}), points, weights);
    };
    for (const double off : {-2e-13, -1e-12, 0.0, 1e-12, 2e-13}) {
        SCOPED_TRACE(off);
        const TrimmingLoop hole(LoopKind::inner, {half(1, off), half(-1, 0)});
        EXPECT_NEAR(hole.signedArea(), -std::acos(-1.0), 1e-11); // the offset times the radius
    }
}

TEST(CadJson, loops_that_miss_by_the_tolerance_are_closed_and_the_correction_is_remarked) {
    // A gap of 2e-6 at a corner, and an end 1e-8 beyond the rim.
    for (const auto& [moved, distance] :
         {std::pair("6, 4.000002", "2e-06"), std::pair("6, 3.999998", "2e-06"),
          std::pair("6.00000001, 4", "1e-08"), std::pair("6, 4.00000001", "1e-08")}) {
        SCOPED_TRACE(moved);
        const std::string text = replaced(twoPlates(), straight(1, "4", "6, 0", "6, 4"),
                                          straight(1, "4", "6, 0", moved));
        const BrepModel read = readCadJson(written("missing", text));
        EXPECT_NEAR(modelArea(read), 48, 1e-13) << "the corner is the surface's again";
        ASSERT_EQ(read.remarks().size(), 1u);
        EXPECT_NE(read.remarks()[0].find(distance), std::string::npos) << read.remarks()[0];
    }
}

TEST(CadJson, the_tolerance_is_the_callers_else_the_files_else_a_millionth_of_the_size) {
    const auto withGap = [](const std::string& gap) {
        return replaced(twoPlates(), straight(1, "4", "6, 0", "6, 4"),
                        straight(1, "4", "6, 0", ("6, 3." + gap).c_str()));
    };
    const std::string wide = written("wide", withGap("9995")); // the file's tolerance is 0.001
    EXPECT_NO_THROW(readCadJson(wide));
    expectInputError([&] { readCadJson(wide, 1e-5); }, {"open", "(6, 3.9995)"});
    const auto withoutTolerance = [&](const std::string& gap) {
        return written("bare", replaced(withGap(gap), "\"model_tolerance\"", "\"other\""));
    };
    EXPECT_NO_THROW(readCadJson(withoutTolerance("999995"))); // the size is 7.2
    expectInputError([&] { readCadJson(withoutTolerance("99999")); }, {"open"});
    EXPECT_NO_THROW(readCadJson(withoutTolerance("99999"), 1e-4));
    expectRefused("0.001", "-0.001", {"model_tolerance", "-0.001", "[0, inf)"});
}

TEST(CadJson, the_curve_along_a_collapsed_side_may_be_left_out) {
    // A triangle: the top side of its surface is one point.
    const std::string text =
        "{\"breps\": [{\"faces\": [{\"brep_id\": 1, \"surface\": {\"degrees\": [1, 1], "
        "\"knot_vectors\": [[0, 0, 6, 6], [0, 0, 4, 4]], \"control_points\": [[1, [0, 0, 0, 1]], "
        "[2, [1, 0, 0, 1]], [3, [0.5, 1, 0, 1]], [4, [0.5, 1, 0, 1]]]}, \"boundary_loops\": "
        "[{\"trimming_curves\": [" +
        straight(0, "6", "0, 0", "6, 0") + ", " + straight(1, "4", "6, 0", "6, 4") + ", " +
        straight(2, "4", "0, 4", "0, 0") + "]}]}], \"edges\": [{\"brep_id\": 2, \"topology\": " +
        "[{\"brep_id\": 1, \"trim_index\": 2}]}]}]}";
    const BrepModel read = readCadJson(written("triangle", text));
    EXPECT_NEAR(modelArea(read), 0.5, 1e-14);
    EXPECT_EQ(read.nCurves(0), 4);
    EXPECT_EQ(read.edges()[0].trims[0].curve, 3) << "the supplied one comes before";
    EXPECT_EQ(read.curve(0, 3).point(0), Point(0, 4, 0));
    ASSERT_EQ(read.remarks().size(), 1u);
    EXPECT_NE(read.remarks()[0].find("collapsed"), std::string::npos);
    expectInputError(
        [&] { readCadJson(written("square", replaced(text, "[4, [0.5,", "[4, [0.6,"))); },
        {"open"});
}

TEST(CadJson, a_swapped_normal_turns_the_surface_and_keeps_edges_and_points) {
    const BrepModel plain = readCadJson(written("plain", twoPlates()));
    const std::string swapped = replaced(twoPlates(), "\"swapped_surface_normal\": false",
                                         "\"swapped_surface_normal\": true");
    const BrepModel read = readCadJson(written("swapped", swapped));
    const Points before = plain.patch(0).surface().derivatives(1, 3, 1);
    const Points after = read.patch(0).surface().derivatives(5, 3, 1);
    EXPECT_LT((after.row(0) - before.row(0)).norm(), 1e-15);
    EXPECT_LT((after.row(1) + before.row(1)).norm(), 1e-15);
    EXPECT_LT((after.row(2) - before.row(2)).norm(), 1e-15);
    EXPECT_NEAR(modelArea(read), 48, 1e-13);
    EXPECT_LT(largestGap(read, read.edges()[read.edgeNumber("6")]), 1e-14)
        << "the shared edge still names the same curves";
    const std::vector<BrepTrim>& trims = read.edges()[read.edgeNumber("6")].trims;
    EXPECT_EQ(runsAlong(read.curveInSpace(trims[0]), read.curveInSpace(trims[1])),
              trims[0].isForward == trims[1].isForward);
    EXPECT_EQ(read.remarks().size(), 1u) << "no direction contradicts the curves";
}

TEST(CadJson, a_curve_that_nothing_uses_stops_no_file) {
    const std::string broken =
        replaced(straight(9, "6", "0, 0", "6, 0"), "\"degree\": 1", "\"degree\": 7");
    const std::string text =
        replaced(twoPlates(), "\"embedded_edges\": []", "\"embedded_edges\": [" + broken + "]");
    const BrepModel read = readCadJson(written("unused", text));
    ASSERT_EQ(read.remarks().size(), 1u);
    EXPECT_NE(read.remarks()[0].find("not used"), std::string::npos);
    EXPECT_NE(read.remarks()[0].find("embedded_edges[0]"), std::string::npos);
    const std::string used =
        replaced(text, "\"trim_index\": 1, \"relative", "\"trim_index\": 9, \"relative");
    expectInputError([&] { readCadJson(written("used", used)); },
                     {"embedded_edges[0]", "degree 7"});
}

TEST(CadJson, curves_and_surfaces_of_degree24_are_read) {
    Points points = Points::Zero(25, 3);
    points.col(0) = Eigen::VectorXd::LinSpaced(25, 0, 1);
    const NurbsCurve bottom(KnotVector::uniform(24, 1), points);
    const NurbsSurface raised = refine(rectangle(Point::Zero(), 1, 1), 24, 24, 1, 1);
    std::vector<NurbsCurve> loop = TrimmingLoop::around({{0, 0}, {1, 1}}).curves();
    loop[0] = bottom;
    const BrepModel model({{TrimmedPatch(raised, {TrimmingLoop(LoopKind::outer, loop)}, "1")}});
    writeCadJson(model, pathOf("degree24"));
    expectSame(model, readCadJson(pathOf("degree24")));
}

TEST(CadJson, knots_and_coordinates_beyond_double_precision_are_refused) {
    expectRefused("[0, 0, 6, 6], [0, 0, 4, 4]", "[0, 0, 1e-320, 1e-320], [0, 0, 4, 4]",
                  {"knot_vectors[0]", "too short"});
    expectRefused("[0, 0, 6, 6], [0, 0, 4, 4]", "[-1e308, -1e308, 1e308, 1e308], [0, 0, 4, 4]",
                  {"knot_vectors[0]", "1e+308", "1e+50"});
    expectRefused("[2, [6, 0, 0, 1]]", "[2, [6e200, 0, 0, 1]]", {"control point 1", "6e+200"});
}

} // namespace tokay::geometry
