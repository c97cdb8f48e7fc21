// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/OutputFile.hpp"
#include "common/errors.hpp"
#include "fileSizeLimit.hpp"
#include "igaStructure/kinematics/plane/PlaneBody.hpp"
#include "igaStructure/kinematics/solid/exampleSolid.hpp"
#include "igaStructure/output/ResultTable.hpp"
#include "igaStructure/output/VtuMesh.hpp"
#include "igaStructure/run/ResultSeries.hpp"
#include "temporaryDirectory.hpp"
#include "vtuArrays.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(ResultTable, has_a_header_and_a_row_a_step_and_nothing_before_the_first) {
    const TemporaryDirectory directory;
    ResultTable table(directory.file("table.dat"), {"time[s]", "tip.x[m]"});
    EXPECT_FALSE(std::filesystem::exists(directory.file("table.dat")));
    table.addRow({0.1, 1});
    EXPECT_EQ(directory.read("table.dat"), "# time[s] tip.x[m]\n0.1 1\n");
    table.addRow({0.2, -2.5e-7});
    EXPECT_EQ(directory.read("table.dat"), "# time[s] tip.x[m]\n0.1 1\n0.2 -2.5e-07\n");
}

TEST(ResultTable, full_disk_leaves_the_table_of_an_earlier_run) {
    const TemporaryDirectory directory;
    directory.write("table.dat", "# earlier\n");
    ResultTable table(directory.file("table.dat"), {"time[s]"});
    {
        const FileSizeLimit limit(4);
        EXPECT_THROW(table.addRow({1}), OutputError);
    }
    EXPECT_EQ(directory.read("table.dat"), "# earlier\n");
}

namespace {

// Bernstein polynomials of a degree at s.
VectorXd bernstein(int degree, double s) {
    VectorXd values(degree + 1);
    for (int i = 0; i <= degree; ++i) {
        values[i] = std::tgamma(degree + 1) / (std::tgamma(i + 1) * std::tgamma(degree - i + 1)) *
                    std::pow(s, i) * std::pow(1 - s, degree - i);
    }
    return values;
}

MatrixXd evaluateOnPatch(const geometry::NurbsSurface& surface, const VtuMesh& mesh) {
    MatrixXd values(3, mesh.points.size());
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
        values.col(k) = surface.point(mesh.points[k].xi, mesh.points[k].eta);
    }
    return values;
}

} // namespace

TEST(VtuMesh, Bezier_cells_are_the_patch_exactly) {
    for (bool ring : {false, true}) {
        const PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::linear, ring});
        const geometry::NurbsSurface& surface = solid.surface();
        const VtuMesh mesh = bezierMesh(surface);
        const MatrixXd control = fileValues(mesh, evaluateOnPatch(surface, mesh));
        const int nU = mesh.degrees[0] + 1;
        ASSERT_EQ(mesh.cellSize, nU * (mesh.degrees[1] + 1));
        ASSERT_EQ(mesh.connectivity.size() / mesh.cellSize, 8u);
        for (int cell = 0; cell < 8; ++cell) {
            const Location first = mesh.points[cell * mesh.cellSize];
            const Location last = mesh.points[(cell + 1) * mesh.cellSize - 1];
            const VectorXd b = bernstein(mesh.degrees[0], 0.3);
            const VectorXd c = bernstein(mesh.degrees[1], 0.8);
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            double denominator = 0;
            for (int k = 0; k < mesh.cellSize; ++k) {
                const int point = cell * mesh.cellSize + k;
                const double weight = b[k % nU] * c[k / nU] * mesh.weights[point];
                sum += weight * control.col(point);
                denominator += weight;
            }
            const Eigen::Vector3d expected = surface.point(
                first.xi + 0.3 * (last.xi - first.xi), first.eta + 0.8 * (last.eta - first.eta));
            EXPECT_LT((sum / denominator - expected).norm(), 1e-13);
        }
    }
}

TEST(VtuMesh, corners_of_Bezier_cells_come_first_and_counter_clockwise) {
    const PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::linear, false});
    const VtuMesh mesh = bezierMesh(solid.surface());
    const auto corner = [&](int k) {
        const Location& at = mesh.points[mesh.connectivity[k]];
        return Eigen::Vector2d(at.xi, at.eta);
    };
    EXPECT_LT((corner(1) - corner(0) - Eigen::Vector2d(0.5, 0)).norm(), 1e-14);
    EXPECT_LT((corner(2) - corner(1) - Eigen::Vector2d(0, 0.25)).norm(), 1e-14);
    EXPECT_LT((corner(3) - corner(0) - Eigen::Vector2d(0, 0.25)).norm(), 1e-14);
}

TEST(VtuMesh, quads_cover_the_area_of_the_patch) {
    const PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::linear, true});
    const VtuMesh mesh = quadMesh(solid.surface(), 16);
    const MatrixXd points = evaluateOnPatch(solid.surface(), mesh);
    double area = 0;
    for (std::size_t k = 0; k < mesh.connectivity.size(); k += 4) {
        const auto corner = [&](int i) { return points.col(mesh.connectivity[k + i]); };
        const Eigen::Vector3d a = corner(2) - corner(0);
        const Eigen::Vector3d b = corner(3) - corner(1);
        const double twice = a[0] * b[1] - a[1] * b[0];
        EXPECT_GT(twice, 0);
        area += 0.5 * twice;
    }
    const double exact = 0.25 * M_PI * (0.64 - 0.25);
    // 64 chords along a quarter circle: relative error (pi / 2 / 64)^2 / 6.
    EXPECT_NEAR(area, exact, 1.1e-4 * exact);
    EXPECT_LT(area, exact);
}

TEST(ResultSeries, lists_the_start_and_each_time_and_writes_nothing_before) {
    const TemporaryDirectory directory;
    const PlaneBody body(makeExample({Kinematics::planeStrain, Strains::linear, false}));
    OutputOptions options;
    options.directory = directory.file("results");
    options.fields = {"displacement", "velocity", "acceleration", "stress", "vonMisesStress"};
    options.subdivision = 1;
    MotionState state;
    state.displacement = VectorXd::Zero(body.model().nUnknowns());
    state.velocity = state.acceleration = state.displacement;
    ResultSeries series(body, options, "flap", state);
    EXPECT_FALSE(std::filesystem::exists(directory.file("results")));
    state.time = 0.5;
    state.displacement.setConstant(0.25);
    series.add(state);
    state.time = 1;
    series.add(state);
    const std::string pvd = directory.read("results/flap.pvd");
    EXPECT_NE(pvd.find("timestep=\"0\" file=\"flap_00000.vtu\""), std::string::npos) << pvd;
    EXPECT_NE(pvd.find("timestep=\"0.5\" file=\"flap_00001.vtu\""), std::string::npos) << pvd;
    EXPECT_NE(pvd.find("timestep=\"1\" file=\"flap_00002.vtu\""), std::string::npos) << pvd;

    const std::string vtu = directory.read("results/flap_00001.vtu");
    for (const std::string& field : options.fields) {
        EXPECT_NE(vtu.find("Name=\"" + field + "\""), std::string::npos) << field;
    }
    const std::vector<double> displacement =
        vtuArrays(directory.file("results/flap_00001.vtu")).at("displacement");
    ASSERT_EQ(displacement.size(), 8u * 4 * 3); // elements, corners, components
    EXPECT_NEAR(displacement[0], 0.25, 1e-15);
    EXPECT_NEAR(displacement[1], 0.25, 1e-15);
    EXPECT_EQ(displacement[2], 0);
}

TEST(ResultSeries, field_that_the_body_does_not_have_is_reported_with_those_it_has) {
    const PlaneBody body(makeExample({Kinematics::planeStrain, Strains::linear, false}));
    OutputOptions options;
    options.fields = {"bendingMoment"};
    try {
        ResultSeries(body, options, "flap", {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "output.fields: this structure has no 'bendingMoment'; it has: "
                                   "displacement [m], velocity [m/s], acceleration [m/s^2], "
                                   "stress [Pa], vonMisesStress [Pa]");
    }
}
