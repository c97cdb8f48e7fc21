// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "exampleShell.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"
#include "trimmedDisc.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <optional>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::TrimmedPatch;

namespace {

constexpr EdgeMethod methods[] = {EdgeMethod::penalty, EdgeMethod::nitsche, EdgeMethod::lagrange};

DiscError solvedDisc(EdgeMethod method, int degree, int n, int nParts,
                     std::optional<double> penalty = std::nullopt) {
    ShellDescription description = discShell({}, degree, n, nParts);
    description.edgeMethod = method;
    description.penalty = penalty;
    Shell shell(std::move(description));
    return discError(shell, solveStatic(shell));
}

// Two plates that meet at x = 1 along y, with meshes that do not match; the second
// one may be kinked. One edge of the first is clamped.
ShellDescription twoPlates(double kink, Strains strains, EdgeMethod method) {
    const Vector3d along(0, 1, 0);
    const TrimmedPatch first(geometry::plate({0, 0, 0}, {1, 0, 0}, along), "first");
    const TrimmedPatch second(
        geometry::plate({1, 0, 0}, {std::cos(kink), 0, std::sin(kink)}, along), "second");
    ShellDescription plates{
        geometry::BrepModel({{first.refined(3, 3, 2, 1)}, {second.refined(4, 4, 1, 2)}},
                            {{"joint", {{0, right}, {1, left}}}}),
        {0.05, 0.05},
        {1e6, 0, 1}};
    plates.strains = strains;
    plates.edgeMethod = method;
    plates.edgeSupports = {support(left, {true, true, true}, true)};
    return plates;
}

MatrixXd stiffnessOf(const Shell& shell) {
    SparseMatrix tangent;
    shell.internalForce(VectorXd::Zero(shell.nUnknowns()), tangent);
    return MatrixXd(tangent);
}

} // namespace

TEST(ShellEdges, errors_of_nitsche_and_lagrange_fall_with_the_order_of_the_degree) {
    // Clamped disc cut out of squares, in two parts. Orders from 6 elements on: degree + 1
    // of u and (2 at degree 2) of w, degree - 1 of second derivatives; 0.6 below, since
    // the first mesh is coarse.
    constexpr double slack = 0.6;
    for (const EdgeMethod method : {EdgeMethod::nitsche, EdgeMethod::lagrange}) {
        for (const int degree : {3, 4}) {
            const DiscError coarse = solvedDisc(method, degree, 6, 2);
            const int n = degree == 3 ? 24 : 18;
            const DiscError fine = solvedDisc(method, degree, n, 2);
            const auto order = [&](double from, double to) {
                return std::log(from / to) / std::log(n / 6.0);
            };
            EXPECT_GT(order(coarse.deflection, fine.deflection), degree + 1 - slack) << degree;
            EXPECT_GT(order(coarse.bending, fine.bending), degree - 1 - slack) << degree;
            EXPECT_GT(order(coarse.displacement, fine.displacement), degree + 1 - slack) << degree;
            EXPECT_GT(order(coarse.strain, fine.strain), degree - slack) << degree;
        }
        const DiscError coarse = solvedDisc(method, 2, 12, 2);
        const DiscError fine = solvedDisc(method, 2, 24, 2);
        EXPECT_GT(std::log2(coarse.deflection / fine.deflection), 2 - 0.3);
        EXPECT_GT(std::log2(coarse.bending / fine.bending), 1 - 0.3);
    }
}

TEST(ShellEdges, springs_of_nitsche_do_not_lock_the_deflection_of_coarse_meshes) {
    // Springs that hold every sliver by its worst point cost half an order of w there (3.3).
    const DiscError coarse = solvedDisc(EdgeMethod::nitsche, 3, 12, 2);
    const DiscError fine = solvedDisc(EdgeMethod::nitsche, 3, 24, 2);
    EXPECT_GT(std::log2(coarse.deflection / fine.deflection), 4 - 0.2);
}

TEST(ShellEdges, multipliers_leave_nothing_of_a_trace_free) {
    // They are fewer than the functions along a trimmed edge. What they do not see would
    // make the displacement in the plane six times as wrong as by Nitsche's method; 1.7 times.
    const DiscError multipliers = solvedDisc(EdgeMethod::lagrange, 3, 12, 2);
    const DiscError nitsche = solvedDisc(EdgeMethod::nitsche, 3, 12, 2);
    EXPECT_LT(multipliers.displacement, 2 * nitsche.displacement);
    EXPECT_LT(multipliers.strain, 2 * nitsche.strain);
}

TEST(ShellEdges, multipliers_join_membranes_of_rubber) {
    // Two strips in a row, pulled to twice their length. Without Poisson's ratio the stretch is
    // uniform: n = t (mu (lambda - 1 / lambda) + prestress lambda). The rest is the compliance
    // of the multipliers, 1e-6 of an element's.
    ShellDescription strips = twoPlates(0, Strains::nonlinear, EdgeMethod::lagrange);
    strips.bending = false;
    strips.material.law = MaterialLaw::neoHookean;
    strips.prestress = {1e3, 0, 0};
    EdgeSupport far = support(right, {false, true, true});
    far.trims = {{1, right}};
    strips.edgeSupports.push_back(far);
    const double force = 0.05 * (0.5e6 * (2 - 0.5) + 1e3 * 2);
    strips.loads.edgeForces = {{{1, right}, VectorField::constant({force, 0, 0})}};
    Shell shell(std::move(strips));
    const double tip = shell.stateAt(1, 1, 0.5, solveStatic(shell)).displacement[0];
    EXPECT_NEAR(tip, 2, 1e-5);
}

TEST(ShellEdges, joined_plates_bend_as_one_whatever_the_method) {
    // Cantilever of length 2 under an end force: w = F L^3 / (3 D), which cubics hold
    // exactly; penalty gives way by about a thousandth.
    for (const EdgeMethod method : methods) {
        ShellDescription plates = twoPlates(0, Strains::linear, method);
        plates.loads.edgeForces = {{{1, right}, VectorField::constant({0, 0, 1e-3})}};
        Shell shell(std::move(plates));
        const double D = 1e6 * std::pow(0.05, 3) / 12;
        const double expected = 1e-3 * 8 / (3 * D);
        const double tip = shell.stateAt(1, 1, 0.5, solveStatic(shell)).displacement[2];
        const double allowed = method == EdgeMethod::nitsche    ? 1e-9
                               : method == EdgeMethod::lagrange ? 1e-5
                                                                : 1e-2;
        EXPECT_NEAR(tip, expected, allowed * expected) << static_cast<int>(method);
    }
}

TEST(ShellEdges, kinked_plates_carry_bending_across_the_edge_by_nitsche) {
    // Under a force along x at the end; against the penalty method with stiff springs.
    double tips[2];
    for (const bool nitsche : {false, true}) {
        ShellDescription plates = twoPlates(1.1, Strains::linear, EdgeMethod::penalty);
        plates.penalty = 1e6;
        if (nitsche) {
            plates.edgeMethod = EdgeMethod::nitsche;
            plates.penalty.reset();
        }
        plates.loads.edgeForces = {{{1, right}, VectorField::constant({1e-3, 0, 0})}};
        Shell shell(std::move(plates));
        tips[nitsche] = shell.stateAt(1, 1, 0.5, solveStatic(shell)).displacement[0];
    }
    EXPECT_NEAR(tips[1], tips[0], 1e-5 * std::abs(tips[0]));
}

TEST(ShellEdges, rigid_motions_meet_no_force_at_joints) {
    for (const double kink : {0.0, 0.7}) {
        // Nitsche: small ones. Lagrange: any.
        const Shell small(twoPlates(kink, Strains::linear, EdgeMethod::nitsche));
        const VectorXd turned = motion(small, [](const Vector3d& X) -> Vector3d {
            return X + Vector3d(1, 2, 3) + Vector3d(0.2, -0.4, 0.1).cross(X);
        });
        const double scale = stiffnessOf(small).diagonal().maxCoeff();
        EXPECT_LT(small.internalForce(turned).force.lpNorm<Eigen::Infinity>(), 1e-12 * scale);

        const Shell large(twoPlates(kink, Strains::nonlinear, EdgeMethod::lagrange));
        const Eigen::AngleAxisd rotation(4.0, Vector3d(1, -2, 0.5).normalized());
        const VectorXd d = motion(
            large, [&](const Vector3d& X) -> Vector3d { return rotation * X + Vector3d(1, 2, 3); });
        EXPECT_LT(large.internalForce(d).force.lpNorm<Eigen::Infinity>(),
                  1e-13 * stiffnessOf(large).diagonal().maxCoeff());
    }
}

TEST(ShellEdges, tangent_of_multipliers_equals_finite_differences) {
    for (const double kink : {0.0, 0.7}) {
        ShellDescription plates = twoPlates(kink, Strains::nonlinear, EdgeMethod::lagrange);
        plates.penalty = 1e3; // so that the springs do not hide the rest
        const Shell shell(std::move(plates));
        const VectorXd d = randomMotion(shell.nUnknowns(), 0.02);
        SparseMatrix tangent;
        shell.internalForce(d, tangent);
        const double h = 1e-6; // truncation and rounding both below 1e-8
        std::srand(1);
        for (int k = 0; k < 8; ++k) {
            const VectorXd along = VectorXd::Random(d.size());
            const VectorXd difference = (shell.internalForce(d + h * along).force -
                                         shell.internalForce(d - h * along).force) /
                                        (2 * h);
            EXPECT_LT((tangent * along - difference).norm(), 1e-7 * difference.norm());
        }
    }
}

TEST(ShellEdges, plates_of_any_ratio_of_stiffness_bend_as_their_moduli_say) {
    // Cantilever of two parts, moment M at its end: w = M/(2 D1) + M/D1 + M/(2 D2).
    // Rounding of the stiff part's equations shows in the soft one.
    for (const EdgeMethod method : methods) {
        for (int exponent = -6; exponent <= 6; exponent += 2) {
            ShellDescription plates = twoPlates(0, Strains::linear, method);
            const double ratio = std::pow(10.0, exponent);
            plates.faceMaterial = {{1e6, 0, 1}, {1e6 * ratio, 0, 1}};
            plates.loads.edgeMoments = {{{1, right}, ScalarField::constant(-1e-3)}};
            Shell shell(std::move(plates));
            const double D = 1e6 * std::pow(0.05, 3) / 12;
            const double expected = 1e-3 / D * (1.5 + 0.5 / ratio);
            const double tip = shell.stateAt(1, 1, 0.5, solveStatic(shell)).displacement[2];
            EXPECT_NEAR(tip, expected, 2e-3 * expected)
                << static_cast<int>(method) << " " << exponent;
        }
    }
}

TEST(ShellEdges, slivers_do_not_stop_a_trimmed_disc) {
    // Degree 4 on 24 x 24: what trimming leaves of some functions is below rounding. The
    // penalty method's usual springs give way by more than a thousandth.
    EXPECT_LT(solvedDisc(EdgeMethod::penalty, 4, 24, 2, 1e4).deflection, 1e-3);
    EXPECT_LT(solvedDisc(EdgeMethod::nitsche, 4, 24, 2).deflection, 1e-4);
    EXPECT_LT(solvedDisc(EdgeMethod::lagrange, 4, 24, 2).deflection, 1e-4);
}

TEST(ShellEdges, slivers_of_a_surface_with_kinks_meet_no_force_in_rigid_motions) {
    // Control points of a wave: at each knot the second derivative jumps, so no polynomial
    // is that of the element before.
    const geometry::KnotVector knots = geometry::KnotVector::uniform(2, 10);
    const geometry::KnotVector width = geometry::KnotVector::uniform(2, 2);
    geometry::Points points(knots.nBasis() * width.nBasis(), 3);
    for (int k = 0; k < points.rows(); ++k) {
        const int i = k % knots.nBasis();
        points.row(k) << 0.1 * i, 0.3 * (k / knots.nBasis()), 0.05 * std::sin(2.0 * i);
    }
    const TrimmedPatch patch(geometry::NurbsSurface(knots, width, points),
                             {geometry::TrimmingLoop::around({{0, 0}, {0.801, 1}})}, "wave");
    ShellDescription wave{geometry::BrepModel({{patch}}), {0.01}, {1e6, 0.3, 1}};
    wave.strains = Strains::linear;
    const Shell shell(std::move(wave));
    const VectorXd turned = motion(shell, [](const Vector3d& X) -> Vector3d {
        return X + Vector3d(1, 2, 3) + Vector3d(0.2, -0.4, 0.1).cross(X);
    });
    const double scale = stiffnessOf(shell).diagonal().maxCoeff();
    EXPECT_LT(shell.internalForce(turned).force.lpNorm<Eigen::Infinity>(), 1e-12 * scale);
}

TEST(ShellEdges, method_that_is_not_chosen_is_the_best_that_is_possible) {
    ShellDescription plates = twoPlates(0, Strains::linear, EdgeMethod::penalty);
    plates.edgeMethod.reset();
    EXPECT_EQ(plates.chosenEdgeMethod(), EdgeMethod::nitsche);
    plates.material.law = MaterialLaw::neoHookean;
    EXPECT_EQ(plates.chosenEdgeMethod(), EdgeMethod::lagrange);
    plates.bending = false;
    EXPECT_EQ(plates.chosenEdgeMethod(), EdgeMethod::nitsche);
    plates.strains = Strains::nonlinear;
    EXPECT_EQ(plates.chosenEdgeMethod(), EdgeMethod::lagrange);
    plates.bending = true;
    EXPECT_EQ(plates.chosenEdgeMethod(), EdgeMethod::lagrange);
    plates.penalty = 1e4;
    EXPECT_EQ(plates.chosenEdgeMethod(), EdgeMethod::penalty);
}

TEST(ShellEdges, springs_build_a_tangent_only_when_asked_and_the_same_forces_without) {
    for (const EdgeMethod method : methods) {
        for (const Strains strains : {Strains::linear, Strains::nonlinear}) {
            if (method == EdgeMethod::nitsche && strains == Strains::nonlinear) {
                continue;
            }
            const Shell shell(twoPlates(0.5, strains, method));
            const Eigen::VectorXd d = 0.01 * Eigen::VectorXd::Random(shell.nUnknowns());
            ASSERT_FALSE(shell.constraints().couplings.empty());
            for (const auto& coupling : shell.constraints().couplings) {
                const EdgeCoupling::Answer whole = coupling->answer(d, strains, true);
                const EdgeCoupling::Answer forces = coupling->answer(d, strains, false);
                EXPECT_EQ(whole.tangent.rows(), whole.force.size());
                EXPECT_EQ(forces.tangent.size(), 0);
                EXPECT_EQ(forces.force, whole.force);
                EXPECT_EQ(forces.energy, whole.energy);
            }
        }
    }
}

TEST(ShellEdges, nitsche_refuses_what_it_cannot_do) {
    EXPECT_THROW(Shell(twoPlates(0, Strains::nonlinear, EdgeMethod::nitsche)), InputError);
    ShellDescription plates = twoPlates(0, Strains::linear, EdgeMethod::nitsche);
    plates.material.law = MaterialLaw::neoHookean;
    EXPECT_THROW(Shell(std::move(plates)), InputError);
}
