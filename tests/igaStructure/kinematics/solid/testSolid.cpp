// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "exampleVolume.hpp"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Side;

namespace {

double stiffnessScale(const Solid& solid) {
    SparseMatrix tangent;
    solid.internalForce(VectorXd::Zero(solid.nUnknowns()), tangent);
    return VectorXd(tangent.diagonal()).maxCoeff();
}

const SolidKind neoHookeanRing{Strains::nonlinear, MaterialLaw::neoHookean, true};

bool isInside(const Solid& solid, int node) {
    const int nU = solid.volume().u().nBasis();
    const int nV = solid.volume().v().nBasis();
    const int nW = solid.volume().w().nBasis();
    const int i = node % nU;
    const int j = node / nU % nV;
    const int k = node / nU / nV;
    return i > 0 && i + 1 < nU && j > 0 && j + 1 < nV && k > 0 && k + 1 < nW;
}

} // namespace

class SolidKinds : public testing::TestWithParam<SolidKind> {};

INSTANTIATE_TEST_SUITE_P(All, SolidKinds, testing::ValuesIn(solidKinds()));

TEST_P(SolidKinds, tangent_equals_finite_differences) {
    const Solid solid(exampleVolume(GetParam()));
    const VectorXd d = randomMotion(solid.nUnknowns(), 0.02);
    SparseMatrix tangent;
    solid.internalForce(d, tangent);
    // Central differences: the truncation error falls with h^2, that of rounding
    // grows with 1/h; at this h both are below 1e-8.
    const double h = 2e-6;
    MatrixXd differences(solid.nUnknowns(), solid.nUnknowns());
    for (int k = 0; k < solid.nUnknowns(); ++k) {
        const VectorXd shift = h * VectorXd::Unit(solid.nUnknowns(), k);
        differences.col(k) =
            (solid.internalForce(d + shift).force - solid.internalForce(d - shift).force) / (2 * h);
    }
    EXPECT_LT((MatrixXd(tangent) - differences).norm(), 1e-7 * differences.norm());
}

TEST_P(SolidKinds, internal_force_is_the_derivative_of_strain_energy) {
    const Solid solid(exampleVolume(GetParam()));
    const VectorXd d = randomMotion(solid.nUnknowns(), 0.02);
    const VectorXd direction = VectorXd::LinSpaced(solid.nUnknowns(), -1, 1).array().sin();
    const double h = 2e-6;
    const double difference =
        (solid.strainEnergy(d + h * direction) - solid.strainEnergy(d - h * direction)) / (2 * h);
    const double derivative = solid.internalForce(d).force.dot(direction);
    EXPECT_NEAR(difference, derivative, 1e-7 * std::abs(derivative)); // as for the tangent
}

TEST_P(SolidKinds, mass_of_a_uniform_motion_is_the_mass_of_the_body) {
    const Solid solid(exampleVolume(GetParam()));
    const SparseMatrix mass = solid.massMatrix();
    const double volume = GetParam().isRing ? 0.25 * M_PI * (0.8 * 0.8 - 0.5 * 0.5) * 0.4 : 2;
    // The integrand is polynomial; only on the ring, rational, is the rule not exact.
    const double tolerance = GetParam().isRing ? 1e-4 : 1e-12;
    for (int c = 0; c < 3; ++c) {
        VectorXd uniform = VectorXd::Zero(solid.nUnknowns());
        for (int k = c; k < solid.nUnknowns(); k += 3) {
            uniform[k] = 1;
        }
        EXPECT_NEAR(uniform.dot(mass * uniform), 3000 * volume, tolerance * 3000 * volume);
        EXPECT_NEAR(uniform.dot(solid.lumpedMassMatrix() * uniform), solid.mass(),
                    1e-12 * solid.mass());
    }
}

TEST_P(SolidKinds, uniform_strain_gives_uniform_stress_and_no_force_inside) {
    const Solid solid(exampleVolume(GetParam()));
    Matrix3d A;
    A << 1.01, 0.02, -0.01, -0.005, 0.97, 0.03, 0.01, -0.02, 1.02;
    const VectorXd d = linearMotion(solid, A);
    const Matrix3d expected = solid.stateAt({0.1, 0.2, 0.3}, d).cauchyStress;
    for (const double xi : {0.0, 0.37, 1.0}) {
        for (const double eta : {0.0, 0.61, 1.0}) {
            const Matrix3d stress = solid.stateAt({xi, eta, 0.8}, d).cauchyStress;
            EXPECT_LT((stress - expected).norm(), 1e-10 * expected.norm());
        }
    }
    const VectorXd force = solid.internalForce(d).force;
    for (int k = 0; k < solid.volume().nControlPoints(); ++k) {
        if (isInside(solid, k)) {
            // Patch test; the rule is exact but for the ring's rational functions.
            const double tolerance = GetParam().isRing ? 1e-3 : 1e-12;
            EXPECT_LT(force.segment<3>(3 * k).norm(), tolerance * force.norm());
        }
    }
}

TEST(Solid, rigid_motion_at_any_rotation_gives_no_strain_if_strains_are_nonlinear) {
    for (const SolidKind& kind : solidKinds()) {
        if (kind.strains == Strains::linear) {
            continue;
        }
        const Solid solid(exampleVolume(kind));
        // A sum of a few hundred products of this size, each rounded.
        const double rounding = 1e-13 * stiffnessScale(solid) * solid.size();
        for (const double angle : {0.1, 1.0, 2.5, M_PI, 6.0}) {
            const Matrix3d rotation =
                Eigen::AngleAxisd(angle, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
            VectorXd d = linearMotion(solid, rotation);
            for (int k = 0; k < d.size(); k += 3) {
                d.segment<3>(k) += Vector3d(3, -1, 2);
            }
            EXPECT_LT(solid.internalForce(d).force.lpNorm<Eigen::Infinity>(), rounding);
            EXPECT_LT(solid.stateAt({0.3, 0.4, 0.5}, d).cauchyStress.norm(),
                      1e-13 * solid.material().youngsModulus);
        }
    }
}

TEST(Solid, Cauchy_stress_follows_a_rotation) {
    const Solid solid(exampleVolume(neoHookeanRing));
    Matrix3d stretch;
    stretch << 1.2, 0.1, 0, 0.1, 0.9, -0.05, 0, -0.05, 1.1;
    const Matrix3d Q = Eigen::AngleAxisd(2, Vector3d(0, 1, 1).normalized()).toRotationMatrix();
    const Vector3d at(0.3, 0.6, 0.2);
    const Matrix3d still = solid.stateAt(at, linearMotion(solid, stretch)).cauchyStress;
    const Matrix3d turned = solid.stateAt(at, linearMotion(solid, Q * stretch)).cauchyStress;
    EXPECT_LT((turned - Q * still * Q.transpose()).norm(), 1e-12 * still.norm());
}

TEST(Solid, neo_Hookean_stress_of_a_simple_shear_is_the_formula) {
    const Solid solid(exampleVolume(neoHookeanRing));
    Matrix3d F = Matrix3d::Identity();
    F(0, 1) = 0.4;
    const Matrix3d stress = solid.stateAt({0.5, 0.5, 0.5}, linearMotion(solid, F)).cauchyStress;
    const double mu = 4e6 / 2.6; // J = 1, so sigma = mu (F F^T - 1)
    EXPECT_LT((stress - mu * (F * F.transpose() - Matrix3d::Identity())).norm(), 1e-12 * mu);
}

TEST(Solid, forces_and_tangent_are_the_same_to_the_last_bit_for_any_number_of_threads) {
    SolidDescription description = exampleVolume(neoHookeanRing);
    description.volume = geometry::refine(description.volume, {2, 2, 2}, {2, 2, 3});
    Solid solid(std::move(description));
    const VectorXd d = randomMotion(solid.nUnknowns(), 0.01);
    solid.setThreads(1);
    SparseMatrix one;
    const VectorXd force = solid.internalForce(d, one).force;
    const double energy = solid.strainEnergy(d);
    for (const int nThreads : {2, 3, 4}) {
        solid.setThreads(nThreads);
        SparseMatrix several;
        EXPECT_EQ(solid.internalForce(d, several).force, force);
        EXPECT_EQ(solid.strainEnergy(d), energy);
        EXPECT_TRUE(
            std::equal(one.valuePtr(), one.valuePtr() + one.nonZeros(), several.valuePtr()));
    }
}

TEST(Solid, pressure_on_a_closed_surface_has_no_resultant) {
    SolidDescription description = exampleVolume(neoHookeanRing);
    for (int side = 0; side < 6; ++side) {
        description.loads.pressures.push_back(
            {static_cast<Side>(side), ScalarField::constant(1e4)});
    }
    const Solid solid(std::move(description));
    VectorXd force = VectorXd::Zero(solid.nUnknowns());
    solid.addFollowerForce(randomMotion(solid.nUnknowns(), 0.02), 0, force);
    const Eigen::Map<const Eigen::Matrix3Xd> nodal(force.data(), 3, force.size() / 3);
    EXPECT_LT(nodal.rowwise().sum().norm(), 1e-4 * nodal.norm()); // rational: quadrature
}

TEST(Solid, tangent_of_pressure_equals_finite_differences) {
    SolidDescription description = exampleVolume(neoHookeanRing);
    const ScalarField pressure{[](const geometry::Point& x, double) { return 1e4 * (1 + x[2]); },
                               false, true};
    description.loads.pressures = {{Side::back, pressure}, {Side::top, pressure}};
    const Solid solid(std::move(description));
    EXPECT_FALSE(solid.hasSymmetricTangent());
    const VectorXd d = randomMotion(solid.nUnknowns(), 0.02);
    SparseMatrix derivative;
    solid.internalForce(d, derivative);
    derivative *= 0;
    solid.subtractFollowerDerivative(d, 0, derivative);
    const VectorXd direction = VectorXd::LinSpaced(solid.nUnknowns(), -1, 1).array().sin();
    const double h = 1e-4; // the force is quadratic: no truncation error
    VectorXd plus = VectorXd::Zero(d.size());
    VectorXd minus = plus;
    solid.addFollowerForce(d + h * direction, 0, plus);
    solid.addFollowerForce(d - h * direction, 0, minus);
    const VectorXd difference = (plus - minus) / (2 * h);
    EXPECT_LT((derivative * direction + difference).norm(), 1e-9 * difference.norm());
}

TEST(Solid, tangent_is_symmetric_where_the_rim_of_the_pressure_is_held) {
    SolidDescription description = exampleVolume(neoHookeanRing);
    description.loads.pressures = {{Side::back, ScalarField::constant(1e4)}};
    EXPECT_FALSE(Solid(description).hasSymmetricTangent());
    description.supports = {{{Side::left}, {false, true, false}},
                            {{Side::right}, {true, false, false}},
                            {{Side::bottom}, {false, false, true}},
                            {{Side::top}, {false, false, true}}};
    const Solid solid(std::move(description));
    EXPECT_TRUE(solid.hasSymmetricTangent());
    SparseMatrix tangent;
    const VectorXd d = VectorXd::Zero(solid.nUnknowns());
    solid.internalForce(d, tangent);
    tangent *= 0;
    solid.subtractFollowerDerivative(d, 0, tangent);
    double largest = 0;
    double asymmetry = 0;
    const MatrixXd matrix(tangent);
    for (int i = 0; i < matrix.rows(); ++i) {
        for (int j = 0; j < i; ++j) {
            if (!solid.fixed()[i] && !solid.fixed()[j]) {
                largest = std::max(largest, std::abs(matrix(i, j)));
                asymmetry = std::max(asymmetry, std::abs(matrix(i, j) - matrix(j, i)));
            }
        }
    }
    EXPECT_LT(asymmetry, 1e-4 * largest); // rational: quadrature
    EXPECT_GT(largest, 0);
}

TEST(Solid, pressure_presses_onto_each_side_of_a_box) {
    for (int number = 0; number < 6; ++number) {
        SolidDescription description =
            exampleVolume({Strains::linear, MaterialLaw::stVenantKirchhoff, false});
        const auto side = static_cast<Side>(number);
        description.loads.pressures.push_back({side, ScalarField::constant(5)});
        Solid solid(std::move(description));
        const VectorXd force = solid.externalForce(0);
        const Eigen::Map<const Eigen::Matrix3Xd> nodal(force.data(), 3, force.size() / 3);
        const int axis = number / 2;
        const double area = axis == 0 ? 1 : 2;
        const Vector3d inwards = (number % 2 == 0 ? 1 : -1) * Vector3d::Unit(axis);
        EXPECT_LT((nodal.rowwise().sum() - 5 * area * inwards).norm(), 1e-12) << number;
    }
}

TEST(Solid, dead_loads_have_the_right_sums_and_follow_time) {
    SolidDescription description = exampleVolume(neoHookeanRing);
    description.loads.tractions.push_back(
        {Side::top, {[](const geometry::Point&, double t) { return Vector3d(t, 2, 0); }, true}});
    description.loads.gravities.push_back(VectorField::constant({0, 0, -10}));
    Solid solid(std::move(description));
    const double area = 0.25 * M_PI * (0.8 * 0.8 - 0.5 * 0.5);
    for (const double t : {0.0, 3.0}) {
        const VectorXd force = solid.externalForce(t);
        const Eigen::Map<const Eigen::Matrix3Xd> nodal(force.data(), 3, force.size() / 3);
        const Vector3d expected(t * area, 2 * area, -10 * 3000 * 0.4 * area);
        EXPECT_LT((nodal.rowwise().sum() - expected).norm(), 1e-5 * expected.norm()); // rational
    }
}

TEST(Solid, free_rigid_motions_are_named) {
    SolidDescription description =
        exampleVolume({Strains::linear, MaterialLaw::stVenantKirchhoff, false});
    EXPECT_TRUE(Solid(description).freeRigidMotions().empty());
    description.supports = {{{Side::left, Side::bottom}, {true, true, true}}};
    EXPECT_THAT(Solid(description).freeRigidMotions(),
                testing::ElementsAre(testing::StartsWith("rotation about z through (0, 0, ")));
    description.supports = {{{Side::left}, {true, false, false}},
                            {{Side::left, Side::bottom, Side::back}, {true, true, true}}};
    EXPECT_EQ(Solid(description).freeRigidMotions().size(), 1u);
}

TEST(Solid, volume_turned_inside_out_is_refused_with_the_place) {
    const geometry::NurbsVolume box = geometry::block({0, 0, 0}, {1, 1, 1});
    geometry::Points points = box.controlPoints();
    points.col(2) *= -1;
    try {
        Solid({geometry::NurbsVolume(box.u(), box.v(), box.w(), points)});
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("turned inside out near x = "), std::string::npos) << message;
        EXPECT_NE(message.find("element 1 of 1 along xi"), std::string::npos) << message;
    }
}

TEST(Solid, incompressible_material_is_refused) {
    SolidDescription description = exampleVolume(neoHookeanRing);
    description.material.law = MaterialLaw::incompressibleNeoHookean;
    EXPECT_THROW(Solid(std::move(description)), InputError);
}
