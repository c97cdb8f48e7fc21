// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/OutputFile.hpp"
#include "geometry/brep/writeModelVtu.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/sampleLoops.hpp"
#include "geometry/sampleModels.hpp"
#include "geometry/trimming/chords.hpp"
#include "geometry/trimming/patchTriangles.hpp"
#include "vtuArrays.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

namespace tokay::geometry {

namespace {

const double pi = std::acos(-1.0);

Point corner(const PatchTriangles& mesh, std::size_t triangle, int i) {
    return mesh.points.row(mesh.triangles[triangle][i]);
}

double area(const PatchTriangles& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        sum += 0.5 * (corner(mesh, i, 1) - corner(mesh, i, 0))
                         .cross(corner(mesh, i, 2) - corner(mesh, i, 0))
                         .norm();
    }
    return sum;
}

} // namespace

TEST(Chords, leave_curves_by_no_more_than_the_tolerance) {
    const NurbsCurve curve = sampleCurve();
    std::size_t before = 0;
    for (const double tolerance : {1e-1, 1e-3, 1e-5}) {
        const std::vector<double> parameters = chordParameters(curve, tolerance);
        double largest = 0;
        for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
            for (const double t : sampleParameters(9)) {
                const Point a = curve.point(parameters[i]), b = curve.point(parameters[i + 1]);
                const Point p =
                    curve.point(parameters[i] + t * (parameters[i + 1] - parameters[i])) - a;
                const Point along = (b - a).normalized();
                largest = std::max(largest, (p - p.dot(along) * along).norm());
            }
        }
        EXPECT_LE(largest, 1.05 * tolerance); // sampled at quarters
        EXPECT_GT(largest, 0.05 * tolerance) << "needlessly fine";
        EXPECT_GT(parameters.size(), before);
        before = parameters.size();
    }
}

TEST(PatchTriangles, of_a_cylinder_stay_within_the_tolerance) {
    const TrimmedPatch cylinder(cylinderPatch(Point::Zero(), 1, 2, 0, 2 * pi));
    for (const double tolerance : {1e-2, 1e-4}) {
        const PatchTriangles mesh = patchTriangles(cylinder, tolerance);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const Point centre = (corner(mesh, i, 0) + corner(mesh, i, 1) + corner(mesh, i, 2)) / 3;
            EXPECT_GE(centre.head<2>().norm(), 1 - tolerance);
            const Point normal = (corner(mesh, i, 1) - corner(mesh, i, 0))
                                     .cross(corner(mesh, i, 2) - corner(mesh, i, 0));
            EXPECT_GT(normal.head<2>().dot(centre.head<2>()), 0) << "the normal points outwards";
        }
        EXPECT_NEAR(area(mesh), 4 * pi, 4 * pi * tolerance);
    }
}

TEST(PatchTriangles, of_a_trimmed_patch_cover_it_without_cracks_inside) {
    const TrimmedPatch patch(square(5), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.45),
                                         circleLoop(LoopKind::inner, {0.55, 0.45}, 0.2)});
    const double tolerance = 1e-4;
    const PatchTriangles mesh = patchTriangles(patch, tolerance);
    EXPECT_NEAR(area(mesh), pi * (0.2025 - 0.04), 2 * pi * 0.65 * tolerance);
    std::map<std::pair<int, int>, int> sides;
    for (const auto& triangle : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            ++sides[std::minmax(triangle[i], triangle[(i + 1) % 3])];
        }
    }
    for (const auto& [side, n] : sides) {
        if (n == 2) {
            continue;
        }
        // A free side lies on a loop.
        const Parameters middle =
            0.5 * (mesh.parameters[side.first] + mesh.parameters[side.second]);
        const double outer = std::abs((middle - Parameters(0.5, 0.5)).norm() - 0.45);
        const double inner = std::abs((middle - Parameters(0.55, 0.45)).norm() - 0.2);
        EXPECT_EQ(n, 1);
        EXPECT_LT(std::min(outer, inner), 2 * tolerance);
    }
}

TEST(PatchTriangles, refuse_a_tolerance_that_is_not_positive) {
    expectInputError([] { patchTriangles(TrimmedPatch(square(1)), 0); }, {"chord tolerance", "0"});
}

TEST(ModelVtu, lists_every_cell_and_names_every_face) {
    const BrepModel model = twoSquares();
    const std::string path = testing::TempDir() + "tokayModel.vtu";
    writeModelVtu(model, path);
    auto arrays = vtuArrays(path);
    const std::size_t nCells = arrays["types"].size(), nPoints = arrays["xi"].size();
    EXPECT_EQ(arrays["Points"].size(), 3 * nPoints);
    EXPECT_EQ(arrays["offsets"].size(), nCells);
    EXPECT_EQ(arrays["offsets"].back(), arrays["connectivity"].size());
    EXPECT_LT(*std::max_element(arrays["connectivity"].begin(), arrays["connectivity"].end()),
              nPoints);
    int nLines = 0;
    for (std::size_t i = 0; i < nCells; ++i) {
        const bool isLine = arrays["types"][i] == 4;
        nLines += isLine;
        EXPECT_EQ(arrays["edge"][i] >= 0, isLine);
    }
    EXPECT_EQ(nLines, 9); // the shared edge has two sides
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("\n108 101 102 116 0 114 105 103 104 116 0\n"), std::string::npos)
        << "left and right, each ended by a zero";
}

TEST(ModelVtu, says_when_the_file_cannot_be_written) {
    const std::string path = "/dev/null/model.vtu";
    try {
        writeModelVtu(twoSquares(), path);
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("/dev/null"), std::string::npos) << error.what();
    }
}

} // namespace tokay::geometry
