// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/mortar/EdgeQuadrature.hpp"
#include "mapper/mortar/EdgeTrace.hpp"
#include "mapper/sampleInterfaces.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <numeric>

namespace tokay::mapper {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::string refusalOf(const CurveInterface& from, const CurveInterface& to) {
    try {
        EdgeQuadrature(from, to, GapLimit());
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

EdgeQuadrature quadratureOf(const CurveInterface& to, int nElements = 3) {
    return {verticalMesh(nElements), to, GapLimit()};
}

Points controlPointsOf(const EdgeQuadrature& edge, const CurveInterface& interface) {
    return interface.coordinates()(edge.functions(), Eigen::all);
}

} // namespace

TEST(EdgeTrace, mass_matrix_on_a_knot_line_is_the_published_one_of_rank_four) {
    const EdgeQuadrature edge = quadratureOf(trimmedEdge(0.5));
    MatrixXd one(4, 4);
    one << 0.025, 0.0145833, 0.00208333, 0,      //
        0.0145833, 0.0416667, 0.025, 0.00208333, //
        0.00208333, 0.025, 0.0416667, 0.0145833, //
        0, 0.00208333, 0.0145833, 0.025;
    const MatrixXd mass = edge.massMatrix();
    ASSERT_EQ(mass.rows(), 8);
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            // half a unit of the last digit printed
            EXPECT_NEAR(mass(i, j), one(i / 2, j / 2), one(i / 2, j / 2) < 0.01 ? 5e-9 : 5e-8);
        }
    }
    EXPECT_EQ(EdgeTrace(edge.values(), edge.weights()).rank(), 4);
}

TEST(EdgeTrace, rank_is_that_of_the_trace_wherever_the_trimming_line_cuts) {
    for (const double xi : {0.0, 0.1, 0.37, 0.5 - 1e-12, 0.5, 0.5 + 1e-12, 0.5 + 1e-6, 0.9, 1.0}) {
        const EdgeQuadrature edge = quadratureOf(trimmedEdge(xi));
        const EdgeTrace trace(edge.values(), edge.weights());
        EXPECT_EQ(trace.rank(), 4) << xi;
        // The trace alone, along the edge, has the condition of quadratic splines.
        const EdgeQuadrature along = quadratureOf(verticalSpline(2, 2));
        EXPECT_NEAR(trace.conditionOnRange(),
                    EdgeTrace(along.values(), along.weights()).conditionOnRange(), 1e-6)
            << xi;
    }
}

TEST(EdgeTrace, basis_is_orthogonal_and_its_rest_leaves_the_edge_where_it_is) {
    const EdgeQuadrature edge = quadratureOf(trimmedEdge(0.37));
    const EdgeTrace trace(edge.values(), edge.weights());
    const MatrixXd& basis = trace.basis();
    ASSERT_EQ(basis.rows(), 12);
    EXPECT_LT((basis.transpose() * basis - MatrixXd::Identity(12, 12)).norm(), 1e-14);
    EXPECT_LT((edge.values() * basis.rightCols(8)).norm(), 1e-14);
    EXPECT_TRUE(trace.isSingular());
}

TEST(EdgeTrace, control_values_of_an_edge_that_the_basis_interpolates_are_the_coefficients) {
    const CurveInterface spline = verticalSpline(2, 3);
    const EdgeQuadrature edge = quadratureOf(spline);
    const EdgeTrace trace(edge.values(), edge.weights());
    EXPECT_FALSE(trace.isSingular());
    EXPECT_EQ(trace.basis(), MatrixXd::Identity(5, 5));
    // The linear field has its coordinates as control values.
    EXPECT_LT((trace.coefficients(edge.points()) - controlPointsOf(edge, spline)).norm(), 1e-13);
}

TEST(EdgeTrace, projection_reproduces_what_the_trace_holds) {
    for (const double xi : {0.37, 0.5, 0.5 + 1e-12}) {
        const EdgeQuadrature edge = quadratureOf(trimmedEdge(xi));
        const EdgeTrace trace(edge.values(), edge.weights());
        const MatrixXd leading = trace.basis().leftCols(trace.rank());
        const MatrixXd mapped = edge.values() * leading * trace.coefficients(edge.points());
        EXPECT_LT((mapped - edge.points()).norm(), 1e-13) << xi;
    }
}

TEST(EdgeTrace, projection_leaves_a_rest_without_moments_on_the_trace) {
    for (const double xi : {0.37, 0.5}) {
        const EdgeQuadrature edge = quadratureOf(trimmedEdge(xi));
        const EdgeTrace trace(edge.values(), edge.weights());
        // No quadratic spline of two spans is this field.
        const VectorXd field = (5 * edge.points().col(1)).array().sin();
        const MatrixXd leading = trace.basis().leftCols(trace.rank());
        const VectorXd rest = field - edge.values() * leading * trace.coefficients(field);
        EXPECT_GT(rest.cwiseAbs().maxCoeff(), 1e-2);
        const VectorXd moments = edge.values().transpose() * edge.weights().asDiagonal() * rest;
        EXPECT_LT(moments.cwiseAbs().maxCoeff(), 1e-14) << xi;
    }
}

TEST(EdgeTrace, condition_is_that_of_the_mass_matrix) {
    const EdgeQuadrature edge = quadratureOf(verticalSpline(3, 4));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(edge.massMatrix());
    const VectorXd& eigenvalues = modes.eigenvalues();
    const double condition = eigenvalues[eigenvalues.size() - 1] / eigenvalues[0];
    EXPECT_NEAR(EdgeTrace(edge.values(), edge.weights()).conditionOnRange(), condition,
                1e-12 * condition * condition);
}

TEST(EdgeQuadrature, integrates_products_along_the_direction_of_the_higher_degree) {
    // Degree 1 across the edge and 3 along it.
    const geometry::NurbsSurface patch =
        refine(geometry::rectangle(Point(-1, 0, 0), 2, 1), 1, 3, 2, 2);
    std::vector<int> numbers(static_cast<std::size_t>(patch.nControlPoints()));
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<std::unique_ptr<InterfaceCurve>> curves;
    curves.push_back(interfaceCurve(
        geometry::CurveOnSurface(geometry::line(Point(0.5, 0, 0), Point(0.5, 1, 0)), patch),
        numbers));
    const CurveInterface onKnotLine(std::move(curves), patch.controlPoints());
    // There the functions are those of the cubic spline along it.
    const MatrixXd expected = quadratureOf(verticalSpline(3, 2)).massMatrix();
    const MatrixXd mass = quadratureOf(onKnotLine).massMatrix();
    ASSERT_EQ(mass.rows(), expected.rows());
    EXPECT_LT((mass - expected).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(EdgeTrace, forces_at_points_keep_force_moment_and_work) {
    for (const double xi : {0.0, 0.37, 0.5, 0.5 + 1e-12}) {
        const CurveInterface interface = trimmedEdge(xi);
        const EdgeQuadrature edge = quadratureOf(interface);
        const EdgeTrace trace(edge.values(), edge.weights());
        MatrixXd reaction(trace.rank(), 2);
        for (Eigen::Index k = 0; k < trace.rank(); ++k) {
            reaction.row(k) << 1 + 0.3 * static_cast<double>(k), std::cos(static_cast<double>(k));
        }
        const MatrixXd onValues = trace.basis().leftCols(trace.rank()) * reaction;
        const MatrixXd atPoints = trace.forcesAtPoints(reaction);
        const Points positions = controlPointsOf(edge, interface);
        EXPECT_LT((atPoints.colwise().sum() - onValues.colwise().sum()).norm(), 1e-13);
        const auto moment = [](const Points& at, const MatrixXd& force) {
            return at.col(0).dot(force.col(1)) - at.col(1).dot(force.col(0));
        };
        EXPECT_NEAR(moment(edge.points(), atPoints), moment(positions, onValues), 1e-13);
        const VectorXd motion = VectorXd::LinSpaced(onValues.rows(), -1, 2).array().square();
        EXPECT_NEAR((edge.values() * motion).dot(atPoints.col(0)), motion.dot(onValues.col(0)),
                    1e-12);
    }
}

TEST(EdgeQuadrature, edges_apart_are_refused_with_the_gap) {
    const std::string text = refusalOf(verticalMesh(3, 0.25), trimmedEdge(0.5));
    EXPECT_TRUE(contains(text, "do not lie on each other") && contains(text, "0.25 m away"))
        << text;
}

TEST(EdgeQuadrature, an_edge_that_the_other_one_covers_only_in_part_is_refused) {
    Points vertices(2, 3);
    vertices << 0, 0, 0, 0, 0.5, 0;
    const CurveInterface half = lineMesh(vertices, {{0, 1}});
    EXPECT_TRUE(contains(refusalOf(verticalMesh(3), half), "0.5 m away"));
    EXPECT_TRUE(contains(refusalOf(half, verticalMesh(3)), "m away"));
}

TEST(EdgeQuadrature, largest_gap_is_the_distance_of_the_edges) {
    EXPECT_NEAR(EdgeQuadrature(verticalMesh(3, 0.003), trimmedEdge(0.5), GapLimit()).largestGap(),
                0.003, 1e-15);
}

TEST(EdgeTrace, degree_along_a_trimming_curve_is_the_product_with_the_patchs) {
    // An arc of degree 2 through a patch of degree 2.
    const geometry::NurbsSurface patch =
        refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 2, 2);
    std::vector<int> numbers(static_cast<std::size_t>(patch.nControlPoints()));
    std::iota(numbers.begin(), numbers.end(), 0);
    geometry::CurveOnSurface arc(geometry::arc(Point(0.5, 0.5, 0), 0.3, 0, 1), patch);
    EXPECT_EQ(interfaceCurve(std::move(arc), numbers)->degree(), 4);
}

} // namespace tokay::mapper
