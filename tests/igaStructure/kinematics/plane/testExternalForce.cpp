// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/kinematics/solid/exampleSolid.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

namespace {

// Sum of forces, and their moment about the origin.
Eigen::Vector3d resultant(const geometry::NurbsSurface& surface, const VectorXd& force) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < surface.nControlPoints(); ++k) {
        const auto X = surface.controlPoints().row(k);
        const auto f = force.segment<2>(2 * k);
        sum += Eigen::Vector3d(f[0], f[1], X[0] * f[1] - X[1] * f[0]);
    }
    return sum;
}

ExternalForce edgeForce(const geometry::NurbsSurface& surface, geometry::Edge edge,
                        const char* tractionX, const char* tractionY) {
    Loads loads;
    loads.tractions.push_back({edge, {Formula(tractionX, ""), Formula(tractionY, "")}});
    return {surface, exampleMaterial(Kinematics::planeStress), loads};
}

} // namespace

TEST(ExternalForce, traction_keeps_sum_and_moment) {
    const auto surface = geometry::refine(geometry::rectangle({0, 0, 0}, 0.1, 1), 2, 3, 2, 4);
    ExternalForce force = edgeForce(surface, geometry::Edge::left, "100*y", "7");
    const Eigen::Vector3d sum = resultant(surface, force.at(0));
    const double thickness = 0.2;
    EXPECT_NEAR(sum[0], 50 * thickness, 1e-12 * 50);
    EXPECT_NEAR(sum[1], 7 * thickness, 1e-12 * 7);
    EXPECT_NEAR(sum[2], -100.0 / 3 * thickness, 1e-12 * 50);
}

TEST(ExternalForce, traction_on_an_arc_acts_on_its_length) {
    const auto surface =
        geometry::refine(geometry::ringSector({0, 0, 0}, 0.5, 0.8, 0, 0.5 * M_PI), 2, 3, 2, 8);
    ExternalForce force = edgeForce(surface, geometry::Edge::right, "1", "0");
    // The integrand is rational: quadrature error, not rounding.
    EXPECT_NEAR(resultant(surface, force.at(0))[0], 0.2 * 0.8 * 0.5 * M_PI, 1e-9);
}

TEST(ExternalForce, gravity_acts_on_the_whole_mass_and_follows_time) {
    const auto surface = geometry::refine(geometry::rectangle({0, 0, 0}, 0.1, 1), 2, 3, 2, 4);
    Loads loads;
    loads.gravities.push_back({{Formula("0", ""), Formula("-9.81*t", "")}});
    ExternalForce force(surface, exampleMaterial(Kinematics::planeStrain), loads);
    EXPECT_EQ(force.at(0).norm(), 0);
    EXPECT_NEAR(resultant(surface, force.at(2))[1], -2 * 9.81 * 300, 1e-10 * 6000);
    EXPECT_NEAR(resultant(surface, force.at(1))[1], -9.81 * 300, 1e-10 * 3000);
}

TEST(ExternalForce, formula_without_a_value_says_where_and_when) {
    const auto surface = geometry::refine(geometry::rectangle({0, 0, 0}, 0.1, 1), 2, 3, 2, 4);
    Loads loads;
    loads.gravities.push_back(
        {{Formula("1/(t - 1)", "case.yaml:3:4: loads[0]: "), Formula("0", "")}});
    ExternalForce force(surface, exampleMaterial(Kinematics::planeStrain), loads);
    force.at(0);
    try {
        force.at(1);
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find("case.yaml:3:4: loads[0]: formula '1/(t - 1)' gives"), 0u)
            << message;
        EXPECT_NE(message.find("t = 1"), std::string::npos) << message;
    }
}
