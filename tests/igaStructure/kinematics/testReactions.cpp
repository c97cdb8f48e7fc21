// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/kinematics/ReactionColumns.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

using namespace tokay;
using namespace tokay::structure;

namespace {

std::unique_ptr<Body> makePart(const std::string& geometry, const std::string& model,
                               const std::string& supports, const std::string& loads) {
    const std::string threes = geometry.find("block") == 0  ? "3, 3, 3"
                               : geometry.find("line") == 0 ? "3"
                                                            : "3, 3";
    return makeBody(readCaseText(
        "geometry:\n  " + geometry + "\ndiscretisation: {degree: [" + threes + "], elements: [" +
            threes + "]}\nmodel: " + model +
            "\nmaterial: {type: StVenantKirchhoff, youngsModulus: 1e6, poissonsRatio: 0.3, "
            "density: 10}\nsupports:\n" +
            supports + "loads:\n" + loads + "time: {scheme: static, step: 1, end: 1}\n",
        "case.yaml"));
}

// Columns by name, after a static solution.
std::map<std::string, double> reactions(Body& body, const Coordinates& about = {}) {
    TimeIntegrator integrator(body.model(), TimeScheme::quasiStatic(), {1e-13, 40, true}, 0);
    integrator.beginTimeStep(1, 1);
    integrator.solve();
    integrator.acceptTimeStep();
    const ReactionColumns columns(body, about);
    const std::vector<std::string> names = columns.names();
    const std::vector<double> values = columns.values(integrator.state());
    EXPECT_EQ(names.size(), values.size());
    std::map<std::string, double> all;
    for (std::size_t k = 0; k < names.size(); ++k) {
        all[names[k]] = values[k];
    }
    return all;
}

} // namespace

TEST(Reactions, of_a_plane_cantilever_balance_force_and_moment) {
    // A traction p along x on the left edge, x = 0 and y from 0 to 1, about (0.2, 0.3).
    const auto body = makePart(
        "rectangle: {origin: [0, 0], size: [0.4, 1]}", "{kinematics: planeStrain, strains: linear}",
        "  - {edge: bottom, fix: [x, y]}\n", "  - {edge: left, traction: [60, 0]}\n");
    auto found = reactions(*body, {{0.2, 0.3, 0}, false});
    // Rounding of one solution.
    EXPECT_NEAR(found["bottom.fx[N]"], -60, 1e-9);
    EXPECT_NEAR(found["bottom.fy[N]"], 0, 1e-9);
    EXPECT_NEAR(found["bottom.mz[N.m]"], 60 * (0.5 - 0.3), 1e-9);
    EXPECT_EQ(found.size(), 3U);
}

TEST(Reactions, of_two_supports_add_up_to_the_loads) {
    for (const std::string strains : {"linear", "nonlinear"}) {
        const auto body =
            makePart("block: {origin: [0, 0, 0], size: [2, 1, 1]}",
                     "{kinematics: solid, strains: " + strains + "}",
                     "  - {faces: [left], fix: [x, y, z]}\n  - {faces: [right, top], fix: [y, z]}\n"
                     "  - {faces: [left], fix: [x]}\n",
                     "  - {gravity: [3, 0, -9]}\n");
        auto found = reactions(*body);
        EXPECT_NEAR(found["left.fx[N]"] + found["right-top.fx[N]"], -60, 1e-8);
        EXPECT_NEAR(found["left.fz[N]"] + found["right-top.fz[N]"], 180, 1e-8);
        EXPECT_LT(std::abs(found["left.fz[N]"]), 180);
        EXPECT_EQ(found["left-2.fx[N]"], 0); // what two hold counts for the first
    }
}

TEST(Reactions, of_weak_edges_are_the_forces_of_their_method) {
    for (const std::string method : {"penalty", "nitsche", "lagrange"}) {
        for (const std::string weak : {"no", "yes"}) {
            const auto body = makePart(
                "rectangle: {origin: [0, 0], size: [2, 1]}",
                "{kinematics: shell, strains: linear, thickness: 0.1, edgeMethod: " + method + "}",
                "  - {edge: left, fix: [x, y, z, rotation], weak: " + weak + "}\n",
                "  - {traction: [3, 0, -9]}\n");
            auto found = reactions(*body);
            // Stiff springs multiply rounding, by 1e6 at most.
            EXPECT_NEAR(found["left.fx[N]"], -6, 1e-7) << method << weak;
            EXPECT_NEAR(found["left.fz[N]"], 18, 1e-7) << method << weak;
            EXPECT_NEAR(found["left.my[N.m]"], -18, 1e-6) << method << weak;
            EXPECT_NEAR(found["left.mx[N.m]"], 9, 1e-6) << method << weak;
        }
    }
}

TEST(Reactions, of_a_moved_weak_edge_are_those_of_the_exact_one) {
    const auto lifted = [](const std::string& weak) {
        const auto body = makePart("rectangle: {origin: [0, 0], size: [2, 1]}",
                                   "{kinematics: shell, strains: linear, thickness: 0.1}",
                                   "  - {edge: left, fix: [x, y, z, rotation]}\n"
                                   "  - {edge: right, fix: [z], displacement: [0, 0, 0.1], weak: " +
                                       weak + "}\n",
                                   "  - {traction: [0, 0, 0]}\n");
        auto found = reactions(*body);
        EXPECT_NEAR(found["left.fz[N]"], -found["right.fz[N]"], 1e-6 * found["right.fz[N]"]);
        return found["right.fz[N]"];
    };
    // Nitsche's method does not move the boundary; bending of a cantilever, 3 E I w / l^3, of a
    // plate that may arch.
    EXPECT_NEAR(lifted("yes"), lifted("no"), 2e-3 * lifted("no"));
    EXPECT_NEAR(lifted("no"), 3 * 1e6 * 1e-3 / 12 * 0.1 / 8, 0.1 * lifted("no"));
}

TEST(Reactions, of_a_clamped_beam_have_its_moment) {
    const auto body =
        makePart("line: {from: [0, 0], to: [1.2, 1.6]}",
                 "{kinematics: beam, strains: linear, thickness: 0.1}",
                 "  - {end: start, fix: [x, y, rotation]}\n", "  - {end: end, force: [5, -2]}\n");
    auto found = reactions(*body);
    EXPECT_NEAR(found["start.fx[N]"], -5, 1e-9);
    EXPECT_NEAR(found["start.fy[N]"], 2, 1e-9);
    // About the origin: minus x fy - y fx.
    EXPECT_NEAR(found["start.mz[N.m]"], -(1.2 * -2 - 1.6 * 5), 1e-8);
}
