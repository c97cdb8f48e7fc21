// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/kinematics/solid/exampleSolid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Displacements X -> A X - X of all control points: exact for a linear map,
// because the functions of the patch reproduce it.
VectorXd linearMotion(const PlaneSolid& solid, const Eigen::Matrix2d& A) {
    VectorXd displacement(solid.nUnknowns());
    for (int k = 0; k < solid.surface().nControlPoints(); ++k) {
        const Eigen::Vector2d X = solid.surface().controlPoints().row(k).head<2>();
        displacement.segment<2>(2 * k) = A * X - X;
    }
    return displacement;
}

VectorXd randomVector(Eigen::Index size, double amplitude) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    VectorXd vector(size);
    for (double& value : vector) {
        value = uniform(generator);
    }
    return vector;
}

double stiffnessScale(const PlaneSolid& solid) {
    SparseMatrix tangent;
    solid.internalForce(VectorXd::Zero(solid.nUnknowns()), tangent);
    return VectorXd(tangent.diagonal()).maxCoeff();
}

} // namespace

class PlaneSolidKinds : public testing::TestWithParam<Example> {};

INSTANTIATE_TEST_SUITE_P(All, PlaneSolidKinds, testing::ValuesIn(exampleKinds()));

TEST_P(PlaneSolidKinds, tangent_equals_finite_differences) {
    const PlaneSolid solid = makeExample(GetParam());
    const double amplitude = 0.05 * solid.size();
    const VectorXd d = randomVector(solid.nUnknowns(), amplitude);
    SparseMatrix tangent;
    solid.internalForce(d, tangent);
    // Central differences of a cubic: the truncation error falls with h^2, that
    // of rounding grows with 1/h; at h = 1e-5 of the body both are below 1e-8.
    const double h = 1e-5 * solid.size();
    MatrixXd differences(solid.nUnknowns(), solid.nUnknowns());
    for (int k = 0; k < solid.nUnknowns(); ++k) {
        VectorXd shift = VectorXd::Zero(solid.nUnknowns());
        shift[k] = h;
        differences.col(k) =
            (solid.internalForce(d + shift).force - solid.internalForce(d - shift).force) / (2 * h);
    }
    EXPECT_LT((MatrixXd(tangent) - differences).norm(), 1e-7 * differences.norm());
}

TEST_P(PlaneSolidKinds, force_with_and_without_tangent_is_the_same) {
    const PlaneSolid solid = makeExample(GetParam());
    const VectorXd d = randomVector(solid.nUnknowns(), 0.05 * solid.size());
    SparseMatrix tangent;
    const VectorXd withTangent = solid.internalForce(d, tangent).force;
    EXPECT_LT((withTangent - solid.internalForce(d).force).norm(), 1e-12 * withTangent.norm());
}

TEST_P(PlaneSolidKinds, internal_force_is_the_derivative_of_strain_energy) {
    const PlaneSolid solid = makeExample(GetParam());
    const VectorXd d = randomVector(solid.nUnknowns(), 0.05 * solid.size());
    const VectorXd direction = randomVector(solid.nUnknowns(), 1);
    const double h = 1e-5 * solid.size();
    const double difference =
        (solid.strainEnergy(d + h * direction) - solid.strainEnergy(d - h * direction)) / (2 * h);
    const double derivative = solid.internalForce(d).force.dot(direction);
    EXPECT_NEAR(difference, derivative, 1e-7 * std::abs(derivative)); // as for the tangent
}

TEST_P(PlaneSolidKinds, mass_of_a_uniform_motion_is_the_mass_of_the_body) {
    const Example example = GetParam();
    const PlaneSolid solid = makeExample(example);
    const SparseMatrix mass = solid.massMatrix();
    for (int c = 0; c < 2; ++c) {
        VectorXd uniform = VectorXd::Zero(solid.nUnknowns());
        for (int k = c; k < solid.nUnknowns(); k += 2) {
            uniform[k] = 1;
        }
        // Degree + 1 Gauss points integrate a polynomial patch exactly; on the
        // ring's rational one the error is that of the quadrature.
        const double tolerance = example.ring ? 1e-6 : 1e-12;
        EXPECT_NEAR(uniform.dot(mass * uniform), exampleMass(example),
                    tolerance * exampleMass(example));
    }
}

TEST_P(PlaneSolidKinds, uniform_strain_gives_uniform_stress_and_no_force_inside) {
    const PlaneSolid solid = makeExample(GetParam());
    Eigen::Matrix2d A;
    A << 1.01, 0.02, -0.005, 0.97;
    const VectorXd d = linearMotion(solid, A);
    const Eigen::Matrix3d expected = solid.stateAt(0.1, 0.2, d).cauchyStress;
    for (double xi : {0.0, 0.37, 1.0}) {
        for (double eta : {0.0, 0.61, 1.0}) {
            EXPECT_LT((solid.stateAt(xi, eta, d).cauchyStress - expected).norm(),
                      1e-10 * expected.norm());
        }
    }
    const VectorXd force = solid.internalForce(d).force;
    const int nU = solid.surface().u().nBasis();
    const int nV = solid.surface().v().nBasis();
    for (int j = 1; j + 1 < nV; ++j) {
        for (int i = 1; i + 1 < nU; ++i) {
            // Patch test; the ring's quadrature is not exact.
            const double tolerance = GetParam().ring ? 1e-6 : 1e-12;
            EXPECT_LT(force.segment<2>(2 * (i + nU * j)).norm(), tolerance * force.norm());
        }
    }
}

TEST(PlaneSolid, rotation_by_any_angle_gives_no_strain_if_strains_are_nonlinear) {
    for (bool ring : {false, true}) {
        const PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::nonlinear, ring});
        for (double angle : {0.1, 1.0, 2.5, 3.14, 6.0}) {
            Eigen::Matrix2d rotation;
            rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
            const VectorXd d = linearMotion(solid, rotation);
            // A sum of a few dozen products of this size, each rounded.
            const double rounding = 1e-14 * stiffnessScale(solid) * solid.size();
            EXPECT_LT(solid.internalForce(d).force.lpNorm<Eigen::Infinity>(), rounding);
            EXPECT_LT(solid.strainEnergy(d), rounding * solid.size() * 1e-12);
        }
    }
}

TEST(PlaneSolid, rotation_gives_strain_if_strains_are_linear) {
    const PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::linear, false});
    Eigen::Matrix2d rotation;
    rotation << 0, -1, 1, 0;
    EXPECT_GT(solid.strainEnergy(linearMotion(solid, rotation)), 0);
}

TEST(PlaneSolid, uniaxial_plane_stress_has_the_stress_of_Hookes_law) {
    const PlaneSolid solid = makeExample({Kinematics::planeStress, Strains::linear, false});
    const PlaneMaterial& material = solid.material();
    Eigen::Matrix2d A = Eigen::Matrix2d::Identity();
    A(0, 0) += 1e-3;
    A(1, 1) -= 1e-3 * material.poissonsRatio; // free to contract
    const Eigen::Matrix3d stress = solid.stateAt(0.5, 0.5, linearMotion(solid, A)).cauchyStress;
    EXPECT_NEAR(stress(0, 0), 1e-3 * material.youngsModulus, 1e-9 * material.youngsModulus);
    EXPECT_NEAR(stress(1, 1), 0, 1e-12 * material.youngsModulus);
    EXPECT_EQ(stress(2, 2), 0);
}

TEST(PlaneSolid, Cauchy_stress_follows_a_rotation) {
    const PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::nonlinear, false});
    Eigen::Matrix2d stretch;
    stretch << 1.2, 0.1, 0.1, 0.9;
    Eigen::Matrix3d Q = Eigen::Matrix3d::Identity();
    Q.topLeftCorner<2, 2>() << std::cos(1.0), -std::sin(1.0), std::sin(1.0), std::cos(1.0);
    const Eigen::Matrix3d still =
        solid.stateAt(0.3, 0.6, linearMotion(solid, stretch)).cauchyStress;
    const Eigen::Matrix3d turned =
        solid.stateAt(0.3, 0.6, linearMotion(solid, Q.topLeftCorner<2, 2>() * stretch))
            .cauchyStress;
    EXPECT_LT((turned - Q * still * Q.transpose()).norm(), 1e-12 * still.norm());
}

TEST(PlaneSolid, patch_that_folds_over_is_refused_with_the_place) {
    geometry::Points points(4, 3);
    points << 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0; // clockwise
    const auto linear = geometry::KnotVector::uniform(1, 1);
    try {
        PlaneSolid(geometry::NurbsSurface(linear, linear, points), PlaneMaterial{}, Strains::linear,
                   {}, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("the geometry folds over near x = "),
                  std::string::npos)
            << error.what();
    }
}
