// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/expectInputError.hpp"
#include "mapper/conservation.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/sampleInterfaces.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace tokay::mapper {

namespace {

MortarOptions minimumNorm() {
    MortarOptions options;
    options.singular = SingularMass::minimumNorm;
    return options;
}

MortarOptions dual() {
    MortarOptions options;
    options.basis = MortarBasis::dual;
    return options;
}

/// Error of the field on the destination, which does not ask for its values.
double fieldError(const MortarMapping& mapping, const Points& mapped, const Points& expected) {
    return (mapping.massMatrix() * (mapped - expected)).norm() /
           (mapping.massMatrix() * expected).norm();
}

void expectPatchTest(const CurveInterface& from, const CurveInterface& to,
                     const MortarOptions& options) {
    const MortarMapping mapping(from, to, options);
    const Points mapped = mapping.apply(linearField(from.coordinates()));
    EXPECT_LT(fieldError(mapping, mapped, linearField(to.coordinates())), 1e-12);
    EXPECT_LT(mapping.report().rowSumError, 1e-12);
    EXPECT_NEAR(mapping.report().coverage, 1, 1e-12);
    const Points forces = mapping.massMatrix() * probeForces(to.nValues());
    expectForceAndMomentConserved(mapping, forces, from.coordinates(), to.coordinates());
    expectTransposesEqual(mapping, from.nValues(), to.nValues());
}

} // namespace

TEST(MortarMapping, passes_the_patch_test_between_line_meshes_that_do_not_match) {
    expectPatchTest(verticalMesh(7), verticalMesh(5), {});
    expectPatchTest(verticalMesh(5), verticalMesh(7), {});
    expectPatchTest(verticalMesh(3), verticalMesh(300), {});
    expectPatchTest(verticalMesh(300), verticalMesh(3), {});
}

TEST(MortarMapping, passes_the_patch_test_whatever_the_order_of_the_sources_elements) {
    Points vertices(8, 3);
    std::vector<std::array<int, 2>> elements;
    for (int i = 0; i < 8; ++i) {
        vertices.row(i) << 0, i / 7.0, 0;
    }
    for (const int i : {4, 0, 6, 2, 5, 1, 3}) {
        elements.push_back({i, i + 1});
    }
    expectPatchTest(lineMesh(vertices, elements), verticalMesh(3), {});
}

TEST(MortarMapping, passes_the_patch_test_between_splines_and_line_meshes) {
    expectPatchTest(verticalMesh(7), verticalSpline(2, 4), {});
    expectPatchTest(verticalSpline(3, 4), verticalMesh(9), {});
    expectPatchTest(verticalSpline(2, 5), verticalSpline(3, 4), {});
    expectPatchTest(verticalSpline(4, 3), verticalSpline(1, 11), {});
}

TEST(MortarMapping, maps_constants_and_means_with_values_on_the_elements_of_a_line_mesh) {
    const CurveInterface vertices = verticalMesh(7), faces = verticalFaces(9),
                         others = verticalFaces(5);
    for (const CurveInterface* from : {&vertices, &faces, &others}) {
        for (const CurveInterface* to : {&vertices, &faces, &others}) {
            const MortarMapping mapping(*from, *to);
            EXPECT_LT(mapping.report().rowSumError, 1e-12);
            EXPECT_LT(mapping.report().forceSumError, 1e-12);
            expectTransposesEqual(mapping, from->nValues(), to->nValues());
        }
    }
    // The mean of a linear field over a straight element is its value in the middle.
    expectPatchTest(vertices, faces, {});
    expectPatchTest(verticalSpline(2, 4), faces, {});
    EXPECT_EQ(faces.nValues(), 9);
    EXPECT_LT(MortarMapping(faces, verticalSpline(2, 4)).report().rowSumError, 1e-12);
}

TEST(MortarMapping, passes_the_patch_test_from_the_dual_basis_too) {
    expectPatchTest(verticalMesh(7), verticalMesh(5), dual());
    expectPatchTest(verticalSpline(3, 4), verticalMesh(9), dual());
    const MortarMapping mapping(verticalMesh(7), verticalMesh(5), dual());
    EXPECT_EQ(mapping.massMatrix().nonZeros(), 6) << "M_DD must be diagonal";
    EXPECT_EQ(mapping.report().method, "mortar, dual basis");
}

TEST(MortarMapping, passes_the_patch_test_with_trimmed_edges_anywhere) {
    for (const double trim : {0.5, 0.3, 0.5 - 1e-4, 0.5 + 1e-4, 0.5 - 1e-8, 0.5 + 1e-12}) {
        expectPatchTest(trimmedEdge(trim), verticalSpline(2, 3), {});
        expectPatchTest(verticalMesh(7), trimmedEdge(trim), minimumNorm());
        expectPatchTest(trimmedEdge(0.7), trimmedEdge(trim), minimumNorm());
    }
}

TEST(MortarMapping, reproduces_what_the_destination_holds_of_higher_degree) {
    // A quadratic field from a quadratic to a cubic spline on other knots.
    const SplineInterface from = verticalSpline(2, 5), to = verticalSpline(3, 4);
    const Points exact = probeForces(from.nValues());
    const Points mapped = MortarMapping(from, to).apply(exact);
    const Points back = MortarMapping(to, from).apply(mapped);
    // from's C1 functions are not in to's space, but one quadratic is in both.
    Points quadratic(from.nValues(), 3);
    const std::vector<double> knots = from.pieces()[0].curve.knotVector().knots();
    for (int i = 0; i < from.nValues(); ++i) { // blossom of y^2 at the inner knots
        quadratic.row(i).setConstant(knots[i + 1] * knots[i + 2]);
    }
    const Points there = MortarMapping(from, to).apply(quadratic);
    EXPECT_LT((MortarMapping(to, from).apply(there) - quadratic).norm(), 1e-12);
    EXPECT_GT((back - exact).norm(), 1e-3) << "a rough field cannot survive";
}

TEST(MortarMapping, the_reports_matrix_of_a_trim_line_on_a_knot_line) {
    MortarMapping mapping(verticalMesh(3), trimmedEdge(0.5), minimumNorm());
    // In the report's order: pairs across the line, along the line; our control
    // points count along xi, of which columns 1 and 2 do not vanish there.
    std::vector<int> order;
    for (int j = 0; j < 4; ++j) {
        for (int i = 1; i <= 2; ++i) {
            order.push_back(i + 4 * j);
        }
    }
    const Eigen::MatrixXd all = mapping.massMatrix();
    const Eigen::MatrixXd matrix = all(order, order);
    Eigen::Matrix4d along;
    along << 0.025, 0.0145833, 0.00208333, 0, 0.0145833, 0.0416667, 0.025, 0.00208333, 0.00208333,
        0.025, 0.0416667, 0.0145833, 0, 0.00208333, 0.0145833, 0.025;
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) { // half a unit of the last digit printed
            EXPECT_NEAR(matrix(i, j), along(i / 2, j / 2), 5e-8) << i << ", " << j;
        }
    }
    EXPECT_EQ(mapping.report().nInverted, 8);
    EXPECT_EQ(mapping.report().rank, 4);

    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    EXPECT_NEAR(mapping.report().condition, eigenvalues[7] / eigenvalues[4],
                0.01 * mapping.report().condition);
    EXPECT_NE(mapping.report().text().find("8 x 8, rank 4 (singular)"), std::string::npos);
}

TEST(MortarMapping, a_trim_line_inside_an_element_has_twelve_functions_and_rank_four) {
    const MortarMapping mapping(verticalMesh(3), trimmedEdge(0.3), minimumNorm());
    EXPECT_EQ(mapping.report().nInverted, 12);
    EXPECT_EQ(mapping.report().rank, 4);
}

TEST(MortarMapping, the_minimum_norm_solution_is_the_pseudo_inverses) {
    const CurveInterface from = verticalMesh(3), to = trimmedEdge(0.3);
    const MortarMapping mapping(from, to, minimumNorm());
    const Points values = probeForces(from.nValues());
    const Eigen::MatrixXd mass = mapping.massMatrix();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(mass);
    Eigen::VectorXd inverses = Eigen::VectorXd::Zero(16);
    inverses.tail(4) = eigen.eigenvalues().tail(4).cwiseInverse();
    const Points expected = eigen.eigenvectors() * inverses.asDiagonal() *
                            eigen.eigenvectors().transpose() * (mapping.crossMatrix() * values);
    EXPECT_LT((mapping.apply(values) - expected).norm(), 1e-11 * expected.norm());
}

TEST(MortarMapping, refuses_a_singular_matrix_unless_told_what_to_do) {
    try {
        MortarMapping(verticalMesh(3), trimmedEdge(0.3));
        ADD_FAILURE() << "nothing was thrown";
    } catch (const SolverError& error) {
        const std::string message = error.what();
        for (const char* word : {"singular", "12 functions", "4 dimensions", "minimum norm"}) {
            EXPECT_NE(message.find(word), std::string::npos) << message;
        }
    }
}

TEST(MortarMapping, a_partly_covered_destination_takes_constants_and_counts_the_rest) {
    MortarOptions options;
    options.gapLimit.refuse = false;
    options.gapLimit.relative = 1e-9;
    Points vertices(2, 3);
    vertices << 0, 0, 0, 0, 0.6, 0;
    const CurveInterface from = lineMesh(vertices, {{0, 1}}), to = verticalMesh(10);
    const MortarMapping mapping(from, to, options);
    EXPECT_NEAR(mapping.report().coverage, 0.6, 1e-12);
    const Eigen::VectorXd mapped = mapping.apply(Eigen::VectorXd::Ones(2));
    int nUncovered = 0;
    for (int i = 0; i < 11; ++i) {
        const bool isCovered = i == 0 || to.coordinates()(i - 1, 1) < 0.6;
        nUncovered += !isCovered;
        EXPECT_NEAR(mapped[i], isCovered ? 1 : 0, 1e-12) << i;
    }
    EXPECT_GT(nUncovered, 0);
    EXPECT_EQ(mapping.report().nUncovered, nUncovered);
    options.gapLimit.refuse = true;
    expectInputError([&] { MortarMapping(from, to, options); }, {"do not lie on each other"});
}

TEST(MortarMapping, integrals_of_the_sources_functions_are_exact_however_small_their_elements) {
    Points vertices(4, 3);
    vertices << 0, 0, 0, 0, 1e-4, 0, 0, 0.7, 0, 0, 1, 0;
    const CurveInterface from = lineMesh(vertices, {{0, 1}, {1, 2}, {2, 3}});
    // A hat's integral is half of the lengths beside it.
    const Eigen::RowVectorXd sums =
        Eigen::RowVectorXd::Ones(2) *
        Eigen::MatrixXd(MortarMapping(from, verticalMesh(1)).crossMatrix());
    EXPECT_NEAR(sums[0], 0.5e-4, 1e-16);
    EXPECT_NEAR(sums[1], 0.35, 1e-15);
    EXPECT_NEAR(sums[2], 0.5 * (0.7 - 1e-4 + 0.3), 1e-15);
}

TEST(MortarMapping, products_on_straight_elements_are_exact_without_extra_points) {
    MortarOptions options;
    options.nExtraPoints = 0;
    for (int degree = 1; degree <= 4; ++degree) {
        for (int other = 1; other <= 4; ++other) {
            const SplineInterface a = verticalSpline(degree, 3), b = verticalSpline(other, 4);
            const MortarMapping there(a, b, options), back(b, a, options);
            const Eigen::MatrixXd cross = there.crossMatrix();
            EXPECT_LT((cross.transpose() - Eigen::MatrixXd(back.crossMatrix())).norm(), 1e-14);
            const Eigen::MatrixXd mass = MortarMapping(b, b).massMatrix();
            EXPECT_LT((mass - Eigen::MatrixXd(there.massMatrix())).norm(), 1e-14);
        }
    }
}

TEST(MortarMapping, extra_points_find_the_length_of_a_rational_arc) {
    const SplineInterface arc = quarterCircle(2, 1);
    const auto error = [&](int nExtraPoints) {
        MortarOptions options;
        options.nExtraPoints = nExtraPoints;
        return std::abs(MortarMapping(arc, arc, options).massMatrix().sum() - std::acos(0.0));
    };
    EXPECT_LT(error(2), 0.1 * error(0));
    EXPECT_LT(error(6), 1e-3 * error(2));
}

TEST(MortarMapping, points_between_two_sides_that_are_as_near_are_counted_as_ambiguous) {
    MortarOptions options;
    options.gapLimit.relative = 0.1;
    // In the middle of the flap, away from its top.
    const MortarMapping mapping(flapInterface(), verticalMesh(20), options);
    EXPECT_GT(mapping.report().nAmbiguous, 0.9 * mapping.report().nPoints);
    EXPECT_EQ(MortarMapping(flapInterface(), verticalMesh(20, 0.01), options).report().nAmbiguous,
              0);
}

TEST(MortarMapping, keeps_constants_and_forces_on_curved_sides_that_do_not_coincide) {
    const SplineInterface circle = quarterCircle(2, 6);
    Points vertices(10, 3);
    std::vector<std::array<int, 2>> elements;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::acos(0.0) * i / 9;
        vertices.row(i) << std::cos(angle), std::sin(angle), 0;
        if (i > 0) {
            elements.push_back({i - 1, i});
        }
    }
    const CurveInterface facets = lineMesh(vertices, elements);
    for (const bool ontoSpline : {false, true}) {
        const CurveInterface &from = ontoSpline ? facets : circle,
                             &to = ontoSpline ? static_cast<const CurveInterface&>(circle) : facets;
        const MortarMapping mapping(from, to);
        EXPECT_LT(mapping.report().rowSumError, 1e-12);
        EXPECT_LT(mapping.report().forceSumError, 1e-12);
        expectTransposesEqual(mapping, from.nValues(), to.nValues());
        // The sagitta of a facet of 10 degrees.
        EXPECT_NEAR(mapping.report().largestGap, 1 - std::cos(std::acos(0.0) / 18), 2e-5);
    }
}

} // namespace tokay::mapper
