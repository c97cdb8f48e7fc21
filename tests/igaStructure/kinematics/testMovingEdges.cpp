// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/kinematics/shell/exampleShell.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <Eigen/Geometry>
#include <gmock/gmock.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

struct Part {
    std::string geometry, model, supports;
    std::string discretisation = "degree: [3, 3]\n  elements: [3, 3]";
    std::string material = "StVenantKirchhoff";
};

std::unique_ptr<Body> makePart(const Part& part) {
    return makeBody(readCaseText("geometry:\n  " + part.geometry + "\ndiscretisation:\n  " +
                                     part.discretisation + "\nmodel: " + part.model +
                                     "\nmaterial: {type: " + part.material +
                                     ", youngsModulus: 1e6, poissonsRatio: 0.3, density: 10}\n"
                                     "supports:\n" +
                                     part.supports + "time: {scheme: static, step: 1, end: 1}\n",
                                 "case.yaml"));
}

VectorXd solved(Body& body, int nSteps = 1) {
    TimeIntegrator integrator(body.model(), TimeScheme::quasiStatic(), {1e-12, 40, true}, 0);
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(static_cast<double>(step) / nSteps, 1.0 / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    return integrator.state().displacement;
}

// Largest distance of control points from a map of their reference positions.
template <class Map>
double largestError(const Body& body, const VectorXd& displacement,
                    const std::vector<Location>& locations, const Map& map) {
    const Eigen::MatrixXd X = body.positions(locations);
    const Eigen::MatrixXd u = body.displacements(displacement, locations);
    double largest = 0;
    for (Eigen::Index k = 0; k < X.cols(); ++k) {
        largest = std::max(largest, (u.col(k) - map(Vector3d(X.col(k)))).norm());
    }
    return largest;
}

std::vector<Location> locationsOf(const Body& body, const std::vector<Vector3d>& points) {
    std::vector<Location> locations;
    for (const Vector3d& point : points) {
        locations.push_back(body.closest(point).location);
    }
    return locations;
}

// A linear field in the plane, and its formulas.
Vector3d planeField(const Vector3d& x) {
    return {0.02 * x[0] + 0.01 * x[1] + 0.003, -0.01 * x[0] + 0.03 * x[1], 0};
}
const std::string planeFormulas = "\"t*(0.02*x+0.01*y+0.003)\", \"t*(-0.01*x+0.03*y)\"";

std::string onAllEdges(const std::string& rest) {
    std::string all;
    for (const char* edge : {"left", "right", "bottom", "top"}) {
        all += std::string("  - {edge: ") + edge + ", " + rest + "}\n";
    }
    return all;
}

const std::vector<Vector3d> pointsOfPlate = {{0.3, 0.2, 0}, {1.1, 0.7, 0}, {1.9, 0.95, 0}};

} // namespace

TEST(MovingEdges, linear_field_on_the_boundary_of_a_plane_solid_fills_it) {
    for (const std::string strains : {"linear", "nonlinear"}) {
        const auto body =
            makePart({"rectangle: {origin: [0, 0], size: [2, 1]}",
                      "{kinematics: planeStrain, strains: " + strains + "}",
                      onAllEdges("fix: [x, y], displacement: [" + planeFormulas + "]")});
        // Rounding of the fit and of one solution, or Newton's tolerance.
        EXPECT_LT(largestError(*body, solved(*body), locationsOf(*body, pointsOfPlate), planeField),
                  1e-12);
    }
}

TEST(MovingEdges, linear_field_on_the_boundary_of_a_solid_fills_it) {
    std::string supports;
    for (const char* face : {"left", "right", "bottom", "top", "back", "front"}) {
        supports += std::string("  - {faces: [") + face +
                    "], fix: [x, y, z], displacement: [\"0.02*x+0.01*z\", \"0.01*y\", "
                    "\"t*0.03*(x+z)\"]}\n";
    }
    const auto body = makePart({"block: {origin: [0, 0, 0], size: [2, 1, 1]}",
                                "{kinematics: solid, strains: nonlinear}", supports,
                                "degree: [2, 2, 2]\n  elements: [2, 2, 2]"});
    const auto field = [](const Vector3d& x) {
        return Vector3d(0.02 * x[0] + 0.01 * x[2], 0.01 * x[1], 0.03 * (x[0] + x[2]));
    };
    EXPECT_LT(largestError(*body, solved(*body),
                           locationsOf(*body, {{0.3, 0.2, 0.4}, {1.4, 0.9, 0.7}}), field),
              1e-11);
}

TEST(MovingEdges, edges_and_corners_of_a_solid_move_by_themselves) {
    // Three edges that meet in a corner, of which one moves, and stretches.
    const auto body = makePart(
        {"block: {origin: [0, 0, 0], size: [2, 1, 1]}", "{kinematics: solid, strains: linear}",
         "  - {faces: [left], fix: [x, y, z]}\n"
         "  - {faces: [right, top], fix: [x, y], displacement: [\"0.1*z\", 0.2, 0]}\n"
         "  - {faces: [right, bottom, back], fix: [z], displacement: [0, 0, -0.05]}\n",
         "degree: [2, 2, 2]\n  elements: [2, 2, 2]"});
    const VectorXd u = solved(*body);
    EXPECT_LT(largestError(*body, u, locationsOf(*body, {{2, 1, 0}, {2, 1, 0.3}, {2, 1, 1}}),
                           [&](const Vector3d& x) {
                               const double w =
                                   body->displacements(u, locationsOf(*body, {x}))(2, 0);
                               return Vector3d(0.1 * x[2], 0.2, w);
                           }),
              1e-12);
    EXPECT_NEAR(body->displacements(u, locationsOf(*body, {{2, 0, 0}}))(2, 0), -0.05, 1e-13);
}

class MovingPlate : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Methods, MovingPlate,
                         testing::Values("exact", "penalty", "nitsche", "lagrange"));

TEST_P(MovingPlate, follows_a_linear_field_of_its_edges) {
    const bool exact = GetParam() == "exact";
    const std::string method = exact ? "nitsche" : GetParam();
    for (const std::string kinematics : {"membrane", "shell"}) {
        const auto body =
            makePart({"rectangle: {origin: [0, 0], size: [2, 1]}",
                      "{kinematics: " + kinematics +
                          ", strains: linear, thickness: 0.05, edgeMethod: " + method +
                          (kinematics == "membrane" ? ", prestress: 10}" : "}"),
                      onAllEdges("fix: [x, y, z], displacement: [" + planeFormulas +
                                 ", \"0.01*x-0.02*y\"], weak: " + (exact ? "no" : "yes"))});
        const auto field = [](const Vector3d& x) {
            return Vector3d(planeField(x) + Vector3d(0, 0, 0.01 * x[0] - 0.02 * x[1]));
        };
        // Constant strain is in equilibrium, and Nitsche's method takes its traction. Springs
        // carry that traction by a compliance: 1e-3 or 1e-6 elements of the strain, 3e-2; those
        // of membranes across the plane are as soft for the prestress.
        const double limit = GetParam() == "penalty"    ? 3e-5
                             : GetParam() == "lagrange" ? 3e-8
                                                        : 1e-11;
        EXPECT_LT(largestError(*body, solved(*body), locationsOf(*body, pointsOfPlate), field),
                  limit)
            << kinematics;
    }
}

TEST(MovingEdges, weak_edge_without_strain_is_followed_exactly) {
    // A rigid motion has no traction, so that springs are not strained.
    for (const std::string method : {"penalty", "lagrange"}) {
        const auto body = makePart(
            {"rectangle: {origin: [0, 0], size: [2, 1]}",
             "{kinematics: shell, strains: linear, thickness: 0.05, edgeMethod: " + method + "}",
             "  - {edge: left, fix: [x, y, z], weak: yes, displacement: [-0.1*y, 0.1*x, 0.3*y]}\n"
             "  - {edge: right, fix: [x, y, z], weak: yes, displacement: [-0.1*y, 0.1*x, "
             "0.3*y]}\n"});
        const auto field = [](const Vector3d& x) {
            return Vector3d(-0.1 * x[1], 0.1 * x[0], 0.3 * x[1]);
        };
        // Rounding over the ratio of the stiffness of springs and of bending, 1e9.
        EXPECT_LT(largestError(*body, solved(*body), locationsOf(*body, pointsOfPlate), field),
                  1e-6)
            << method;
    }
}

TEST(MovingEdges, turn_a_shell_by_a_large_rotation_without_strain) {
    // By 2 t about the axis y = 0, z = 0, at two edges of a plate.
    const std::string turn = "\"0\", \"y*(cos(2*t)-1)-z*sin(2*t)\", \"y*sin(2*t)+z*(cos(2*t)-1)\"";
    for (const std::string weak : {"no", "yes"}) {
        const auto body =
            makePart({"plate: {origin: [0, 0, 0], edgeXi: [2, 0, 0], edgeEta: [0, 1, 0.5]}",
                      "{kinematics: shell, strains: nonlinear, thickness: 0.05}",
                      "  - {edge: left, fix: [x, y, z], weak: " + weak + ", displacement: [" +
                          turn + "]}\n  - {edge: right, fix: [x, y, z], weak: " + weak +
                          ", displacement: [" + turn + "]}\n"});
        const VectorXd u = solved(*body, 4);
        const auto field = [](const Vector3d& x) {
            return Vector3d(Eigen::AngleAxisd(2, Vector3d::UnitX()) * x - x);
        };
        const std::vector<Vector3d> points = {{0.4, 0.3, 0.15}, {1.1, 0.8, 0.4}, {2, 0.5, 0.25}};
        EXPECT_LT(largestError(*body, u, locationsOf(*body, points), field), 1e-7) << weak;
        // Of springs, the energy is a difference: their rounding, else Newton's tolerance.
        const auto& model = body->model();
        EXPECT_LT(std::abs(model.strainEnergy(u) + model.supportShift(1).energyAt(u)),
                  1e-8 + 1e-14 * model.strainEnergy(u));
    }
}

TEST(MovingEdges, point_of_a_shell_moves_exactly_where_its_basis_interpolates) {
    const auto body =
        makePart({"rectangle: {origin: [0, 0], size: [2, 1]}",
                  "{kinematics: shell, strains: linear, thickness: 0.05}",
                  "  - {edge: left, fix: [x, y, z, rotation]}\n"
                  "  - {point: [2, 1, 0], fix: [z], displacement: [0, 0, 0.1*t*x]}\n"
                  "  - {point: [1.3, 0.4, 0], fix: [z], displacement: [0, 0, 0.02]}\n"});
    const VectorXd u = solved(*body);
    const Eigen::MatrixXd found =
        body->displacements(u, locationsOf(*body, {{2, 1, 0}, {1.3, 0.4, 0}}));
    EXPECT_NEAR(found(2, 0), 0.2, 1e-14);
    EXPECT_NEAR(found(2, 1), 0.02, 1e-5); // by a spring a thousand times as stiff as an element
}

TEST(MovingEdges, clamped_edge_moves_without_turning) {
    // Between clamps of which one moves across: w = 0.1 (3 s^2 - 2 s^3).
    const auto body = makePart({"rectangle: {origin: [0, 0], size: [2, 1]}",
                                "{kinematics: shell, strains: linear, thickness: 0.05}",
                                "  - {edge: left, fix: [x, y, z, rotation]}\n"
                                "  - {edge: right, fix: [x, z, rotation], displacement: [0, 0, "
                                "0.1*t]}\n"
                                "  - {edge: bottom, fix: [rotation], weak: yes}\n"
                                "  - {edge: top, fix: [rotation], weak: yes}\n"});
    const auto field = [](const Vector3d& x) {
        const double s = 0.5 * x[0];
        return Vector3d(0, 0, 0.1 * (3 * s * s - 2 * s * s * s));
    };
    // A cubic, which the basis holds; free of twist at the edges that may not turn.
    EXPECT_LT(largestError(*body, solved(*body), locationsOf(*body, pointsOfPlate), field), 1e-9);
}

TEST(MovingEdges, end_of_a_beam_moves) {
    // A cantilever whose end is lifted: w = 0.05 (3 s^2 - s^3), turning freely.
    const auto body = makePart({"line: {from: [0, 0], to: [2, 0]}",
                                "{kinematics: beam, strains: linear, thickness: 0.05}",
                                "  - {end: start, fix: [x, y, rotation]}\n"
                                "  - {end: end, fix: [y], displacement: [0, 0.1*t]}\n",
                                "degree: [3]\n  elements: [3]"});
    const auto field = [](const Vector3d& x) {
        const double s = 0.5 * x[0];
        return Vector3d(0, 0.05 * (3 * s * s - s * s * s), 0);
    };
    EXPECT_LT(largestError(*body, solved(*body),
                           locationsOf(*body, {{0.5, 0, 0}, {1.4, 0, 0}, {2, 0, 0}}), field),
              1e-10);
}

TEST(MovingEdges, what_a_support_holds_at_rest_stays_there) {
    // The corner belongs to both edges.
    const auto body = makePart({"rectangle: {origin: [0, 0], size: [2, 1]}",
                                "{kinematics: planeStress, strains: linear, thickness: 1}",
                                "  - {edge: left, fix: [x, y]}\n"
                                "  - {edge: bottom, fix: [y], displacement: [0, 0.1]}\n"});
    const VectorXd u = solved(*body);
    const Eigen::MatrixXd found =
        body->displacements(u, locationsOf(*body, {{0, 0, 0}, {2, 0, 0}}));
    EXPECT_EQ(found(1, 0), 0);
    EXPECT_NEAR(found(1, 1), 0.1, 0.05); // the best fit of what jumps
}

TEST(MovingEdges, mistakes_in_displacements_are_named) {
    const auto messageOf = [](const std::string& kinematics, const std::string& support) {
        try {
            makePart({kinematics == "beam" ? "line: {from: [0, 0], to: [1, 0]}"
                                           : "rectangle: {origin: [0, 0], size: [2, 1]}",
                      "{kinematics: " + kinematics + ", strains: linear" +
                          (kinematics == "planeStrain" ? "}" : ", thickness: 0.1}"),
                      "  - " + support + "\n",
                      kinematics == "beam" ? "degree: [3]\n  elements: [3]"
                                           : "degree: [3, 3]\n  elements: [3, 3]"});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_THAT(messageOf("shell", "{edge: left, fix: [z], displacement: [t, 0, t]}"),
                testing::AllOf(testing::HasSubstr("displacement"),
                               testing::HasSubstr("'t' for x, which is not in fix")));
    EXPECT_THAT(messageOf("planeStrain", "{edge: left, fix: [x, y], displacement: [t, 0, t]}"),
                testing::HasSubstr("displacement"));
    EXPECT_THAT(messageOf("beam", "{end: start, fix: [x, y], displacement: [t]}"),
                testing::HasSubstr("displacement: must have 2 values here, but has 1"));
}
