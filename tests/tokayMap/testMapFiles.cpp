// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJson.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "temporaryDirectory.hpp"
#include "tokayMap/files/writeField.hpp"
#include "tokayMap/mapFiles.hpp"
#include "tokayMap/readSide.hpp"
#include "vtuArrays.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <numeric>

namespace tokay::tool {

namespace {

using mapper::ValuesAt;

double linear(double x, double y) {
    return 1 + 2 * x - 3 * y;
}

/// Unit square of n x n quadrilaterals with the linear field "p" on it.
void writeSquare(const std::string& path, int n, ValuesAt at, double scale = 1) {
    Points vertices((n + 1) * (n + 1), 3);
    std::vector<std::vector<int>> cells;
    Eigen::VectorXd onVertices(vertices.rows()), onFaces(n * n);
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const int a = i + (n + 1) * j;
            vertices.row(a) << scale * i / n, scale * j / n, 0;
            onVertices[a] = linear(1.0 * i / n, 1.0 * j / n);
            if (i < n && j < n) {
                onFaces[static_cast<int>(cells.size())] = linear((i + 0.5) / n, (j + 0.5) / n);
                cells.push_back({a, a + 1, a + n + 2, a + n + 1});
            }
        }
    }
    writeField(path, {vertices, cells, at}, "p", at == ValuesAt::vertices ? onVertices : onFaces);
}

/// The same square as a spline model of one trimmed patch with a round hole.
void writeModel(const std::string& path) {
    using namespace geometry;
    const NurbsCurve circle = arc(Point(0.5, 0.5, 0), 0.2, 0, 2 * std::acos(-1.0));
    TrimmedPatch patch(
        rectangle(Point::Zero(), 1, 1),
        {TrimmingLoop::around({{0, 0}, {1, 1}}), TrimmingLoop(LoopKind::inner, {reversed(circle)})},
        "plate");
    writeCadJson(BrepModel({{std::move(patch)}}), path);
}

double largestLinearError(const std::string& vtu, const std::string& name) {
    const auto arrays = vtuArrays(vtu);
    const std::vector<double>&points = arrays.at("Points"), &values = arrays.at(name);
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        largest = std::max(largest, std::abs(values[i] - linear(points[3 * i], points[3 * i + 1])));
    }
    return largest;
}

class MapFiles : public testing::Test {
  protected:
    MapFiles() {
        options.from = directory.file("from.vtu");
        options.to = directory.file("to.vtu");
        options.field = "p";
        options.output = directory.file("mapped.vtu");
        options.report = directory.file("report.json");
        writeSquare(options.from, 7, ValuesAt::vertices);
        writeSquare(options.to, 5, ValuesAt::vertices);
    }

    double sumOfMapped() const {
        const std::vector<double> values = vtuArrays(options.output).at("p");
        return std::accumulate(values.begin(), values.end(), 0.0);
    }

    TemporaryDirectory directory;
    MapOptions options;
};

} // namespace

TEST_F(MapFiles, takes_a_linear_field_exactly_with_every_operator_but_the_nearest_neighbour) {
    for (const Operator kind : {Operator::nearestElement, Operator::rbf, Operator::mortar}) {
        options.mapping.kind = kind;
        mapFiles(options);
        EXPECT_LT(largestLinearError(options.output, "p"), 1e-12) << static_cast<int>(kind);
    }
    options.mapping.kind = Operator::nearestNeighbour;
    options.mapping.gapLimit = 0.2;
    mapFiles(options);
    EXPECT_NEAR(largestLinearError(options.output, "p"), 0.3, 0.3) << "half a cell of the source";
    EXPECT_GT(largestLinearError(options.output, "p"), 0.01);
}

TEST_F(MapFiles, refuses_a_value_that_is_not_finite_with_its_place) {
    Points vertices(4, 3);
    vertices << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    const Eigen::Vector4d values(1, NAN, 2, 3);
    writeField(options.from, {vertices, {{0, 1, 2, 3}}, ValuesAt::vertices}, "p", values);
    expectInputError([&] { mapFiles(options); }, {"from.vtu", "'p'", "vertex 1", "nan"});
    options.field.clear();
    options.valuesFile = directory.write("values.txt", "1\n2\n3\ninf\n");
    expectInputError([&] { mapFiles(options); }, {"values.txt", "row 3", "inf"});
}

TEST_F(MapFiles, maps_onto_a_trimmed_model_and_writes_its_triangles) {
    options.to = directory.file("plate.json");
    writeModel(options.to);
    options.degree = 2;
    options.nDivisions = 4;
    for (const Operator kind : {Operator::nearestElement, Operator::mortar}) {
        options.mapping.kind = kind;
        options.mapping.mortar.singular = mapper::SingularMass::minimumNorm;
        mapFiles(options);
        EXPECT_LT(largestLinearError(options.output, "p"), 1e-10);
        const auto points = vtuArrays(options.output).at("Points");
        for (std::size_t i = 0; i < points.size(); i += 3) {
            EXPECT_GT(std::hypot(points[i] - 0.5, points[i + 1] - 0.5), 0.19) << "the hole";
        }
    }
}

TEST_F(MapFiles, maps_from_a_spline_model_by_a_formula_and_prints_the_error) {
    options.from = directory.file("plate.json");
    writeModel(options.from);
    options.field.clear();
    options.testFunction = "x^2 - x*y";
    options.degree = 2;
    options.mapping.allowGaps = true; // vertices over the hole
    mapFiles(options);
    const YAML::Node report = YAML::LoadFile(options.report);
    EXPECT_GT(report["mapping"]["nUnmatched"].as<int>(), 0);
    EXPECT_GT(report["largestError"].as<double>(), 0.01) << "the hole";
    options.testFunction = "1 + 2*x - 3*y";
    options.valuesFile.clear();
    options.to = directory.file("corner.vtu");
    writeSquare(options.to, 3, ValuesAt::vertices, 0.1);
    mapFiles(options);
    EXPECT_LT(YAML::LoadFile(options.report)["largestError"].as<double>(), 1e-11);
}

TEST_F(MapFiles, maps_between_models_by_mortar) {
    options.from = options.to = directory.file("plate.json");
    writeModel(options.from);
    options.field.clear();
    options.testFunction = "1 + 2*x - 3*y";
    options.degree = 2;
    options.nDivisions = 3;
    options.mapping.kind = Operator::mortar;
    options.mapping.mortar.singular = mapper::SingularMass::minimumNorm;
    mapFiles(options);
    EXPECT_LT(YAML::LoadFile(options.report)["largestError"].as<double>(), 1e-9);
}

// The tube stands upright on the rim where plate and disc meet. Each place of integration is on
// its own face, to rounding; small cut elements take some digits of the field.
TEST_F(MapFiles, maps_a_model_of_faces_that_meet_at_curves_onto_itself_by_mortar) {
    using namespace geometry;
    const double turn = 2 * std::acos(-1.0);
    const NurbsCurve rim = arc(Point(0.5, 0.5, 0), 0.2, 0, turn);
    const NurbsSurface square = rectangle(Point::Zero(), 1, 1);
    const TrimmingLoop around = TrimmingLoop::around({{0, 0}, {1, 1}});
    std::vector<BrepFace> faces;
    faces.push_back(
        {TrimmedPatch(square, {around, TrimmingLoop(LoopKind::inner, {reversed(rim)})}, "plate")});
    faces.push_back({TrimmedPatch(square, {TrimmingLoop(LoopKind::outer, {rim})}, "disc")});
    faces.push_back({TrimmedPatch(cylinderPatch(Point(0.5, 0.5, 0), 0.2, 0.5, 0, turn))});
    options.from = options.to = directory.file("faces.json");
    writeCadJson(BrepModel(std::move(faces)), options.from);
    options.field.clear();
    options.testFunction = "1 + 2*x - 3*y + z";
    options.degree = 2;
    options.nDivisions = 3;
    options.mapping.kind = Operator::mortar;
    options.mapping.mortar.singular = mapper::SingularMass::minimumNorm;
    mapFiles(options);
    const YAML::Node report = YAML::LoadFile(options.report);
    EXPECT_EQ(report["mapping"]["nUnmatched"].as<int>(), 0);
    EXPECT_LT(report["mapping"]["relativeGap"].as<double>(), 1e-12);
    EXPECT_LT(report["largestError"].as<double>(), 1e-9);
}

namespace {

/// A plate [x, x + 1] x [0, 1] that is trimmed where x is 1, inside an element of thirds;
/// its edges are called plate.0 to plate.3 from the bottom on.
void writeTrimmedPlate(const std::string& path, double x) {
    using namespace geometry;
    const bool isLeft = x < 0.5;
    const ParameterBox kept =
        isLeft ? ParameterBox{{0, 0}, {1 - x, 1}} : ParameterBox{{1 - x, 0}, {1, 1}};
    std::vector<BrepFace> faces = {
        {TrimmedPatch(rectangle(Point(x, 0, 0), 1, 1), {TrimmingLoop::around(kept)}, "plate")}};
    std::vector<BrepEdge> edges = coincidentEdges(faces, 1e-9);
    writeCadJson(BrepModel(std::move(faces), std::move(edges)), path);
}

} // namespace

TEST_F(MapFiles, maps_between_trimmed_edges_with_the_slope_across_them) {
    options.from = directory.file("left.json");
    options.to = directory.file("right.json");
    writeTrimmedPlate(options.from, 0.2);
    writeTrimmedPlate(options.to, 0.7);
    options.edgesFrom = {"plate.1"};
    options.edgesTo = {"plate.3"};
    options.field.clear();
    options.testFunction = "1 + 2*x - 3*y";
    options.degree = 2;
    options.nDivisions = 3;
    options.mapping.kind = Operator::mortar;
    options.mapping.mortar.singular = mapper::SingularMass::gradientTerm;
    mapFiles(options);
    // The whole cut elements of the destination, 1/3 wide, lie on both sides of the edge.
    EXPECT_LT(YAML::LoadFile(options.report)["largestError"].as<double>(), 1e-10);
    EXPECT_LT(largestLinearError(options.output, "values"), 1e-10);
    options.mapping.mortar.singular = mapper::SingularMass::minimumNorm;
    mapFiles(options);
    EXPECT_GT(YAML::LoadFile(options.report)["largestError"].as<double>(), 0.1);
}

TEST_F(MapFiles, refuses_edges_that_are_not_there) {
    options.edgesTo = {"plate.1"};
    expectInputError([&] { mapFiles(options); }, {"to.vtu", "only a spline model"});
    options.to = directory.file("right.json");
    writeTrimmedPlate(options.to, 0.7);
    options.edgesTo = {"plate.7"};
    expectInputError([&] { mapFiles(options); }, {"plate.7", "plate.3"});
}

TEST_F(MapFiles, maps_between_lines_but_not_by_mortar_from_lines_to_faces) {
    options.from = directory.write("a.obj", "v 0 0 0\nv 0.5 0 0\nv 1 0 0\nl 1 2 3\n");
    const std::string faces = options.to;
    options.to = directory.write("b.obj", "v 0 0 0\nv 0.3 0 0\nv 1 0 0\nl 1 2\nl 2 3\n");
    options.field.clear();
    options.testFunction = "1 + 2*x - 3*y";
    options.mapping.kind = Operator::mortar;
    mapFiles(options);
    EXPECT_LT(largestLinearError(options.output, "values"), 1e-13);
    options.mapping.kind = Operator::nearestElement;
    options.toAt = ValuesAt::faces;
    mapFiles(options);
    const std::vector<double> onLines = vtuArrays(options.output).at("values");
    ASSERT_EQ(onLines.size(), 2u);
    EXPECT_NEAR(onLines[0], linear(0.15, 0), 1e-14);
    EXPECT_NEAR(onLines[1], linear(0.65, 0), 1e-14);
    options.mapping.kind = Operator::mortar;
    options.toAt = ValuesAt::vertices;
    options.to = faces;
    expectInputError([&] { mapFiles(options); }, {"a.obj", "lines", "nearestElement"});
}

TEST_F(MapFiles, keeps_the_sum_of_forces_whatever_the_operator_and_the_destination) {
    writeSquare(options.from, 7, ValuesAt::faces);
    writeModel(directory.file("plate.json"));
    const std::vector<double> forces = vtuArrays(options.from).at("p");
    const double sum = std::accumulate(forces.begin(), forces.end(), 0.0);
    options.conservative = true;
    options.mapping.gapLimit = 0.3;
    options.mapping.mortar.singular = mapper::SingularMass::minimumNorm;
    for (const std::string to : {"to.vtu", "plate.json"}) {
        for (const Operator kind : {Operator::nearestNeighbour, Operator::nearestElement,
                                    Operator::rbf, Operator::mortar}) {
            const bool isModel = to == "plate.json";
            if (isModel && (kind == Operator::nearestNeighbour || kind == Operator::rbf)) {
                continue; // refused: see below
            }
            options.to = directory.file(to);
            options.mapping.kind = kind;
            options.mapping.allowGaps = isModel; // faces over the hole
            const std::string text = mapFiles(options);
            EXPECT_NE(text.find("sum of p:"), std::string::npos);
            if (isModel && kind == Operator::mortar) {
                continue; // what acts over the hole has no partner there
            }
            EXPECT_NEAR(sumOfMapped(), sum, 1e-12 * sum * forces.size());
        }
    }
}

TEST_F(MapFiles, writes_a_report_that_programs_can_read) {
    options.mapping.kind = Operator::mortar;
    const std::string text = mapFiles(options);
    const YAML::Node report = YAML::LoadFile(options.report);
    EXPECT_EQ(report["mapping"]["method"].as<std::string>(), "mortar");
    EXPECT_EQ(report["mapping"]["rank"].as<int>(), 36);
    EXPECT_EQ(report["mapping"]["coverage"].as<double>(), 1);
    EXPECT_EQ(report["values"]["largest"].as<double>(), 3);
    EXPECT_EQ(report["values"]["smallest"].as<double>(), -2);
    EXPECT_NEAR(report["mappedValues"]["smallest"].as<double>(), -2, 1e-12);
    EXPECT_NE(report["from"].as<std::string>().find("64 vertices, 49 faces"), std::string::npos);
    EXPECT_NE(text.find("mass matrix 36 x 36, rank 36"), std::string::npos) << text;
}

TEST_F(MapFiles, says_that_millimetres_meet_metres) {
    writeSquare(options.from, 7, ValuesAt::vertices, 1000);
    expectInputError([&] { mapFiles(options); },
                     {"factor of 1000", "mm", "--scale-from 0.001", "from.vtu", "to.vtu"});
    options.scaleFrom = 0.001;
    mapFiles(options);
    EXPECT_LT(largestLinearError(options.output, "p"), 1e-12);
}

TEST_F(MapFiles, takes_values_from_a_table) {
    options.field.clear();
    std::string table = "# one a vertex, two components\n";
    for (int i = 0; i < 64; ++i) {
        table += "2, -1.5\n";
    }
    options.valuesFile = directory.write("values.csv", table);
    mapFiles(options);
    const std::vector<double> values = vtuArrays(options.output).at("values");
    ASSERT_EQ(values.size(), 2u * 36);
    EXPECT_NEAR(values[70], 2, 1e-14);
    EXPECT_NEAR(values[71], -1.5, 1e-14);
    options.valuesFile = directory.write("values.csv", table + "3\n");
    expectInputError([&] { mapFiles(options); }, {"values.csv:66", "1 numbers", "2"});
    options.valuesFile = directory.write("values.csv", "1\n2\n");
    expectInputError([&] { mapFiles(options); }, {"2 rows", "64"});
}

TEST_F(MapFiles, refuses_what_cannot_be_mapped_and_says_what_to_do) {
    options.field = "pressure";
    expectInputError([&] { mapFiles(options); }, {"from.vtu", "'pressure'", "p ", "vertices"});
    options.field.clear();
    expectInputError([&] { mapFiles(options); }, {"--field", "--values", "--test-function"});
    options.testFunction = "x + w";
    expectInputError([&] { mapFiles(options); }, {"--test-function", "x, y, z"});
    options.from = directory.file("plate.json");
    writeModel(options.from);
    options.testFunction = "x";
    options.mapping.kind = Operator::rbf;
    expectInputError([&] { mapFiles(options); }, {"plate.json", "coefficients", "mortar"});
    options.testFunction.clear();
    options.field = "p";
    expectInputError([&] { mapFiles(options); }, {"plate.json", "no fields", "--values"});
    options.from = directory.write("a.stl", "");
    expectInputError([&] { mapFiles(options); }, {"a.stl", ".stl", ".vtu"});
}

TEST(FieldNamed, takes_the_field_on_faces_if_it_is_at_vertices_too) {
    const MeshFile mesh{Points::Zero(1, 3),
                        {},
                        false,
                        {{"p", ValuesAt::vertices, Eigen::VectorXd::Constant(1, 1)},
                         {"p", ValuesAt::faces, Eigen::VectorXd::Constant(1, 2)},
                         {"q", ValuesAt::vertices, Eigen::VectorXd::Constant(1, 3)}}};
    EXPECT_EQ(fieldNamed(mesh, "a.vtp", "p", {}).values(0), 2);
    EXPECT_EQ(fieldNamed(mesh, "a.vtp", "p", ValuesAt::vertices).values(0), 1);
    EXPECT_EQ(fieldNamed(mesh, "a.vtp", "q", {}).values(0), 3);
    expectInputError([&] { fieldNamed(mesh, "a.vtp", "q", ValuesAt::faces); },
                     {"a.vtp", "'q' at faces"});
}

TEST_F(MapFiles, lists_the_fields_of_a_file) {
    EXPECT_EQ(listFields(readMesh(options.from)),
              "  p                        at vertices  1 component, -2 to 3\n");
}

} // namespace tokay::tool
