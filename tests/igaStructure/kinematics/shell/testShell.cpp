// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleShell.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

enum class Kind { linearShell, nonlinearShell, linearMembrane, nonlinearMembrane };

ShellDescription describe(Kind kind) {
    ShellDescription description = exampleShell();
    const bool linear = kind == Kind::linearShell || kind == Kind::linearMembrane;
    description.strains = linear ? Strains::linear : Strains::nonlinear;
    description.bending = kind == Kind::linearShell || kind == Kind::nonlinearShell;
    if (!description.bending) {
        description.prestress = {3e4, 1e4, 5e3};
    }
    return description;
}

// Central differences: the truncation error falls with h^2, that of rounding
// grows with 1/h; at this h both are below 1e-8.
MatrixXd differences(const Shell& shell, const VectorXd& d) {
    const double h = 1e-6 * shell.size();
    MatrixXd result(d.size(), d.size());
    for (Eigen::Index k = 0; k < d.size(); ++k) {
        const VectorXd shift = h * VectorXd::Unit(d.size(), k);
        result.col(k) =
            (shell.internalForce(d + shift).force - shell.internalForce(d - shift).force) / (2 * h);
    }
    return result;
}

double stiffnessScale(const Shell& shell) {
    SparseMatrix tangent;
    shell.internalForce(VectorXd::Zero(shell.nUnknowns()), tangent);
    return VectorXd(tangent.diagonal()).maxCoeff();
}

} // namespace

class ShellKinds : public testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(All, ShellKinds,
                         testing::Values(Kind::linearShell, Kind::nonlinearShell,
                                         Kind::linearMembrane, Kind::nonlinearMembrane));

TEST_P(ShellKinds, tangent_equals_finite_differences) {
    const Shell shell(describe(GetParam()));
    const VectorXd d = randomMotion(shell.nUnknowns(), 0.02 * shell.size());
    SparseMatrix tangent;
    shell.internalForce(d, tangent);
    const MatrixXd expected = differences(shell, d);
    EXPECT_LT((MatrixXd(tangent) - expected).norm(), 1e-7 * expected.norm());
}

TEST_P(ShellKinds, force_is_the_derivative_of_energy) {
    const Shell shell(describe(GetParam()));
    const VectorXd d = randomMotion(shell.nUnknowns(), 0.02 * shell.size());
    const VectorXd direction = randomMotion(shell.nUnknowns(), 1).reverse();
    const double h = 1e-5;
    const double difference =
        (shell.strainEnergy(d + h * direction) - shell.strainEnergy(d - h * direction)) / (2 * h);
    const double derivative = shell.internalForce(d).force.dot(direction);
    EXPECT_NEAR(difference, derivative, 1e-7 * std::abs(derivative)); // as for the tangent
}

TEST_P(ShellKinds, force_with_and_without_tangent_is_the_same) {
    const Shell shell(describe(GetParam()));
    const VectorXd d = randomMotion(shell.nUnknowns(), 0.02 * shell.size());
    SparseMatrix tangent;
    EXPECT_EQ(shell.internalForce(d, tangent).force, shell.internalForce(d).force);
}

TEST_P(ShellKinds, result_is_the_same_to_the_last_bit_for_any_number_of_threads) {
    Shell shell(describe(GetParam()));
    const VectorXd d = randomMotion(shell.nUnknowns(), 0.02 * shell.size());
    shell.setThreads(1);
    SparseMatrix expected;
    const VectorXd force = shell.internalForce(d, expected).force;
    const double energy = shell.strainEnergy(d);
    for (int nThreads : {2, 3, 5}) {
        shell.setThreads(nThreads);
        SparseMatrix tangent;
        EXPECT_EQ(shell.internalForce(d, tangent).force, force);
        EXPECT_TRUE(std::equal(tangent.valuePtr(), tangent.valuePtr() + tangent.nonZeros(),
                               expected.valuePtr()));
        EXPECT_EQ(shell.strainEnergy(d), energy);
    }
}

TEST(Shell, rigid_motion_gives_no_force_at_any_rotation) {
    const Shell shell(exampleShell());
    for (double angle : {1e-6, 0.1, 1.0, M_PI, 7.0}) { // [rad], more than a turn too
        const Eigen::AngleAxisd rotation(angle, Vector3d(1, -2, 0.5).normalized());
        const VectorXd d = motion(shell, [&](const Vector3d& X) -> Vector3d {
            return rotation * X + Vector3d(10, -3, 4);
        });
        // Rounding of displacements of the size 10.
        const double rounding = 1e-14 * stiffnessScale(shell) * 10;
        EXPECT_LT(shell.internalForce(d).force.lpNorm<Eigen::Infinity>(), rounding) << angle;
    }
}

TEST(Shell, small_rigid_motion_of_a_linear_shell_gives_no_force) {
    const Shell shell(describe(Kind::linearShell));
    const VectorXd d = motion(shell, [](const Vector3d& X) -> Vector3d {
        return X + Vector3d(1, 2, 3) + Vector3d(0.3, -0.2, 0.5).cross(X);
    });
    EXPECT_LT(shell.internalForce(d).force.lpNorm<Eigen::Infinity>(),
              1e-13 * stiffnessScale(shell) * d.lpNorm<Eigen::Infinity>());
}

TEST(Shell, mass_of_a_uniform_motion_is_the_mass_of_the_shell) {
    const Shell shell(exampleShell());
    const SparseMatrix mass = shell.massMatrix();
    const VectorXd d =
        motion(shell, [](const Vector3d& X) -> Vector3d { return X + Vector3d::UnitY(); });
    const double expected = 1000 * 0.1 * M_PI * 2 * 3;
    // Gauss points on a rational patch: four a span of a quarter turn in two parts.
    EXPECT_NEAR(d.dot(mass * d), expected, 1e-6 * expected);
}

TEST(Shell, plate_bent_to_a_cylinder_has_the_moment_of_its_curvature) {
    ShellMaterial material{2e11, 0.3, 7800};
    ShellDescription description =
        onePatch(geometry::rectangle({0, 0, 0}, 2, 1), 3, 2, 2, 0.01, material);
    description.strains = Strains::linear;
    const Shell shell(std::move(description));
    // w = k x^2 / 2 with the control points of x^2 in Bernstein form is found by
    // the Greville products: here by least squares on the nodes' own functions.
    const double k = 1e-3;
    const geometry::NurbsSurface& surface = shell.patches()[0]->surface();
    const std::vector<double> greville = surface.u().grevilleAbscissae();
    const int n = surface.u().nBasis();
    MatrixXd N = MatrixXd::Zero(n, n);
    VectorXd w(n);
    for (int i = 0; i < n; ++i) {
        const int span = surface.u().findSpan(greville[i]);
        N.row(i).segment(span - 3, 4) = surface.u().basisDerivatives(span, greville[i], 0).row(0);
        w[i] = 0.5 * k * std::pow(2 * greville[i], 2);
    }
    const VectorXd coefficients = N.partialPivLu().solve(w);
    VectorXd d = VectorXd::Zero(shell.nUnknowns());
    for (int node = 0; node < shell.nodes().count(); ++node) {
        d[3 * node + 2] = coefficients[node % n];
    }
    const double D = 2e11 * 1e-6 / 12 / (1 - 0.09);
    const ShellState state = shell.stateAt(0, 0.3, 0.6, d);
    EXPECT_NEAR(std::abs(state.moment[0]), D * k, 1e-9 * D * k);
    EXPECT_NEAR(state.moment[1], 0.3 * state.moment[0], 1e-9 * D * k);
    EXPECT_NEAR(state.moment[2], 0, 1e-9 * D * k);
    EXPECT_NEAR(state.force.norm(), 0, 1e-9 * D * k / 0.01);
}

TEST(Shell, names_the_rigid_motions_that_supports_leave_free) {
    ShellDescription description = exampleShell();
    EXPECT_EQ(Shell(description).freeRigidMotions().size(), 6);
    description.edgeSupports = {support(bottom, {false, false, true})};
    EXPECT_EQ(Shell(description).freeRigidMotions(),
              (std::vector<std::string>{"translation along x", "translation along y",
                                        "rotation about z"}));
    description.edgeSupports = {support(bottom, {true, true, true})};
    EXPECT_TRUE(Shell(description).freeRigidMotions().empty());
}
