// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/conservation.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/mortar/GradientTerm.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/sampleInterfaces.hpp"
#include "mapper/sampleMeshes.hpp"
#include "mapper/samplePatches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tokay::mapper {

namespace {

using geometry::NurbsSurface;

MortarOptions with(SingularMass singular) {
    MortarOptions options;
    options.singular = singular;
    return options;
}

/// Biquadratic patch [-1, 1] x [0, 1] of n x n elements, and its edge from
/// (start, 0) to (end, 1), which the loop's interior lies to the left of.
struct SlantedEdge {
    NurbsSurface surface;
    double start, end;

    SlantedEdge(int n, double from, double to)
        : surface(refine(geometry::rectangle(Point(-1, 0, 0), 2, 1), 2, 2, n, n)), start(from),
          end(to) {}

    CurveInterface interface(bool isReversed = false) const {
        std::vector<int> numbers(surface.nControlPoints());
        std::iota(numbers.begin(), numbers.end(), 0);
        Points coordinates = surface.controlPoints();
        if (isReversed) {
            std::reverse(numbers.begin(), numbers.end());
            coordinates = coordinates.colwise().reverse().eval();
        }
        std::vector<std::unique_ptr<InterfaceCurve>> curves;
        curves.push_back(interfaceCurve(
            geometry::CurveOnSurface(
                geometry::line(Point((1 + start) / 2, 0, 0), Point((1 + end) / 2, 1, 0)), surface),
            numbers));
        return CurveInterface(std::move(curves), coordinates);
    }
    /// The same place as line elements.
    CurveInterface mesh(int nElements) const {
        Points vertices(nElements + 1, 3);
        std::vector<std::array<int, 2>> elements;
        for (int i = 0; i <= nElements; ++i) {
            const double t = static_cast<double>(i) / nElements;
            vertices.row(i) << start + (end - start) * t, t, 0;
            if (i > 0) {
                elements.push_back({i - 1, i});
            }
        }
        return lineMesh(vertices, elements);
    }
};

double smooth(double x, double y) {
    return 1 + std::sin(3 * y) + 0.3 * std::cos(2 * x + 1);
}

Eigen::VectorXd smooth(const Points& x) {
    Eigen::VectorXd values(x.rows());
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        values[i] = smooth(x(i, 0), x(i, 1));
    }
    return values;
}

/// L2 errors of the mapped smooth field, along the edge and in a strip of half an
/// element on either side that stays in the cut elements of an upright edge.
struct Errors {
    double onEdge, beside;
};

Errors errors(const SlantedEdge& edge, const Eigen::VectorXd& values, double from, double to) {
    const auto& rule = geometry::gaussLegendre(40);
    Errors sums{0, 0};
    for (int j = 0; j < 40; ++j) {
        const double t = rule.points[j];
        const auto squared = [&](double x) {
            const geometry::SurfaceBasis basis = edge.surface.basis((1 + x) / 2, t, 0);
            const double value = basis.N.row(0).dot(values(basis.controlPoints));
            return std::pow(value - smooth(x, t), 2);
        };
        sums.onEdge += rule.weights[j] * squared(edge.start + (edge.end - edge.start) * t);
        for (int i = 0; i < 40; ++i) {
            sums.beside +=
                rule.weights[i] * rule.weights[j] * squared(from + (to - from) * rule.points[i]);
        }
    }
    return {std::sqrt(sums.onEdge), std::sqrt(sums.beside)};
}

/// A quarter of a cylinder of radius 2 and height 3, along which parameters are uneven, and
/// the columns of elements that the line xi = 0.5 cuts.
struct QuarterCylinder {
    NurbsSurface surface =
        refine(geometry::cylinderPatch(Point::Zero(), 2, 3, 0, 0.5 * M_PI), 2, 2, 5, 4);

    double cutArea() const { return 2 * (angle(0.6) - angle(0.4)) * 3; }
    SurfaceInterface trimmed() const {
        const geometry::ParameterBox kept{{0, 0}, {0.5, 1}};
        return onePatch(geometry::TrimmedPatch(surface, {geometry::TrimmingLoop::around(kept)}));
    }
    CurveInterface edge() const {
        std::vector<int> numbers(static_cast<std::size_t>(surface.nControlPoints()));
        std::iota(numbers.begin(), numbers.end(), 0);
        std::vector<std::unique_ptr<InterfaceCurve>> curves;
        curves.push_back(interfaceCurve(
            geometry::CurveOnSurface(geometry::line(Point(0.5, 0, 0), Point(0.5, 1, 0)), surface),
            numbers));
        return CurveInterface(std::move(curves), surface.controlPoints());
    }

  private:
    double angle(double xi) const {
        const Point at = surface.point(xi, 0);
        return std::atan2(at[1], at[0]);
    }
};

/// Integral of the product of both sides' slopes of positions, over components and directions.
double ofPositions(const RowSparseMatrix& term, const Points& to, const Points& from) {
    return (to.transpose() * (term * from)).trace();
}

} // namespace

TEST(GradientTerm, of_positions_is_the_area_of_the_cut_elements_on_a_curved_patch_too) {
    // Along a direction of the surface positions change by 1: the squares are the area, for
    // each direction.
    const QuarterCylinder fine;
    const Points& x = fine.surface.controlPoints();
    QuarterCylinder other;
    other.surface = refine(geometry::cylinderPatch(Point::Zero(), 2, 3, 0, 0.5 * M_PI), 2, 2, 3, 2);
    const SurfaceInterface whole = onePatch(geometry::TrimmedPatch(other.surface));
    const Points& ofOther = other.surface.controlPoints();
    const double area = fine.cutArea();
    // Three Gauss points along an element of about 18 degrees.
    const double error = 1e-6 * area;

    const GradientTerm onPatch = gradientTerm(whole, fine.trimmed());
    EXPECT_NEAR(ofPositions(onPatch.energy, x, x), 2 * area, error);
    EXPECT_NEAR(ofPositions(onPatch.slopes, x, ofOther), 2 * area, error);
    const SurfaceMesh mesh = flatMesh(2, 2, FaceKind::triangles, ValuesAt::vertices);
    const GradientTerm ofMesh = gradientTerm(mesh, fine.trimmed());
    EXPECT_NEAR(ofPositions(ofMesh.energy, x, x), 2 * area, error);
    EXPECT_EQ(ofMesh.slopes.nonZeros(), 0);

    const CurveInterface edge = fine.edge();
    const GradientTerm onEdge = gradientTerm(edge, edge);
    EXPECT_NEAR(ofPositions(onEdge.energy, x, x), area, error);
}

TEST(GradientTerm, fields_that_do_not_change_across_the_edge_are_exact_in_the_cut_elements) {
    for (const double trim : {0.0, 1e-12, 1e-8, 1e-4, 0.05, 0.13}) {
        const SlantedEdge edge(8, trim, trim);
        const CurveInterface to = edge.interface(), from = edge.mesh(11);
        const MortarMapping mapping(from, to, with(SingularMass::gradientTerm));
        const Eigen::VectorXd along =
            (2 - 0.7 * from.coordinates().col(1).array()).matrix(); // linear along the edge
        const Eigen::VectorXd mapped = mapping.apply(along);
        const double left = trim > 0 ? 0 : -0.25, right = left + 0.25; // the cut elements
        for (const double x : {left + 0.01, left + 0.1, right - 0.01}) {
            for (const double y : {0.0, 0.3, 1.0}) {
                const geometry::SurfaceBasis basis = edge.surface.basis((1 + x) / 2, y, 0);
                // Roundings of the trace reach the far side of an element, 1e-4 of it away
                // from the edge, through its slopes.
                EXPECT_NEAR(basis.N.row(0).dot(mapped(basis.controlPoints)), 2 - 0.7 * y, 1e-11)
                    << "trim " << trim << ", at " << x << ", " << y;
            }
        }
    }
}

TEST(GradientTerm, takes_linear_fields_on_the_edge_and_conserves_force_and_moment) {
    for (const double end : {0.13, -0.1, 0.6}) {
        const SlantedEdge edge(8, 0.13, end);
        const CurveInterface to = edge.interface(), from = edge.mesh(11);
        const MortarMapping mapping(from, to, with(SingularMass::gradientTerm));
        const Points mapped = mapping.apply(linearField(from.coordinates()));
        const Points expected = mapping.massMatrix() * linearField(to.coordinates());
        // A slanted edge has traces of any smallness: those below SPQR's tolerance of
        // 20 (rows + columns) roundings, here 1e-12, count as none.
        EXPECT_LT((mapping.massMatrix() * mapped - expected).norm(), 1e-11 * expected.norm());
        EXPECT_LT(mapping.report().rowSumError, 1e-11);
        const Points forces = mapping.massMatrix() * probeForces(to.nValues());
        expectForceAndMomentConserved(mapping, forces, from.coordinates(), to.coordinates());
        if (end == edge.start) {
            expectTransposesEqual(mapping, from.nValues(), to.nValues());
        }
        // A trace of 1e-12 of the largest leaves 4 digits of its value, either way.
        const Points values = linearField(from.coordinates()).array().sin();
        const double work = mapping.apply(values).cwiseProduct(forces).sum();
        EXPECT_NEAR(work, values.cwiseProduct(mapping.applyTransposed(forces)).sum(),
                    1e-7 * values.norm() * forces.norm());
    }
}

TEST(GradientTerm, has_the_trace_of_the_minimum_norm_and_a_better_field_in_the_cut_elements) {
    for (const int n : {8, 16, 32}) {
        const double element = 2.0 / n, trim = 0.3 * element;
        const SlantedEdge edge(n, trim, trim);
        const CurveInterface to = edge.interface(), from = edge.mesh(40 * n);
        const Eigen::VectorXd values = smooth(from.coordinates());
        const auto errorsOf = [&](SingularMass singular) {
            return errors(edge, MortarMapping(from, to, with(singular)).apply(values), 0, element);
        };
        const Errors norm = errorsOf(SingularMass::minimumNorm),
                     gradient = errorsOf(SingularMass::gradientTerm);
        EXPECT_NEAR(gradient.onEdge, norm.onEdge, 1e-9);
        // The slope across the edge is at most 0.6: over half an element.
        EXPECT_LT(gradient.beside, 0.6 * 0.5 * element) << n;
        EXPECT_GT(norm.beside, 0.1) << "the minimum norm does not even hold constants there";
    }
}

TEST(GradientTerm, takes_the_slope_of_a_source_that_knows_one) {
    for (const double trim : {0.0, 1e-12, 1e-4, 0.05, 0.13}) {
        const SlantedEdge other(5, trim, trim), edge(8, trim, trim);
        const CurveInterface from = other.interface(), to = edge.interface();
        const MortarMapping mapping(from, to, with(SingularMass::gradientTerm));
        const Points mapped = mapping.apply(linearField(from.coordinates()));
        const Points expected = linearField(to.coordinates());
        int nActive = 0;
        for (int i = 0; i < to.nValues(); ++i) {
            if (mapped.row(i).norm() > 0) {
                ++nActive;
                // Roundings of the trace reach the far side of an element through its slopes.
                EXPECT_LT((mapped.row(i) - expected.row(i)).norm(), 1e-9) << trim;
            }
        }
        // biquadratic, a column of cut elements, on a knot line one on either side
        EXPECT_EQ(nActive, (trim < 1e-9 ? 4 : 3) * 10) << trim;
        EXPECT_NE(mapping.report().text().find("with the source's slope"), std::string::npos);
    }
}

TEST(GradientTerm, takes_the_sources_slope_where_it_changes_along_the_edge) {
    const SlantedEdge other(5, 0.13, 0.13), edge(8, 0.13, 0.13);
    const CurveInterface from = other.interface(), to = edge.interface();
    // Control values of x y are the products of their coordinates.
    const auto product = [](const Points& x) -> Eigen::VectorXd {
        return x.col(0).cwiseProduct(x.col(1));
    };
    const Eigen::VectorXd mapped = MortarMapping(from, to, with(SingularMass::gradientTerm))
                                       .apply(product(from.coordinates()));
    const Eigen::VectorXd expected = product(to.coordinates());
    for (Eigen::Index i = 0; i < mapped.size(); ++i) {
        EXPECT_TRUE(mapped[i] == 0 || std::abs(mapped[i] - expected[i]) < 1e-9) << i;
    }
}

TEST(GradientTerm, slope_keeps_moments_of_forces_off_the_edge) {
    const SlantedEdge other(5, 0.13, 0.13), edge(8, 0.13, 0.13);
    const CurveInterface from = other.interface(), to = edge.interface();
    const MortarMapping mapping(from, to, with(SingularMass::gradientTerm));
    Points forces = probeForces(to.nValues());
    for (int i = 0; i < to.nValues(); ++i) { // on the functions of cut elements
        if (mapping.apply(from.coordinates()).row(i).norm() == 0) {
            forces.row(i).setZero();
        }
    }
    expectForceAndMomentConserved(mapping, forces, from.coordinates(), to.coordinates());
    expectTransposesEqual(mapping, from.nValues(), to.nValues());
}

TEST(GradientTerm, numbers_of_control_points_do_not_matter) {
    const SlantedEdge other(5, 0.13, 0.13), edge(8, 0.13, 0.13);
    const Points values = linearField(other.surface.controlPoints()).array().sin();
    const Points reversed = values.colwise().reverse();
    const auto options = with(SingularMass::gradientTerm);
    const Points mapped = MortarMapping(other.interface(), edge.interface(), options).apply(values);
    const Points ofReversed =
        MortarMapping(other.interface(true), edge.interface(true), options).apply(reversed);
    // The condition of what the trace leaves open enlarges rounding.
    EXPECT_LT((ofReversed.colwise().reverse() - mapped).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(GradientTerm, error_beside_the_edge_falls_by_one_order_more_with_the_sources_slope) {
    double before = 0;
    for (const int n : {8, 16, 32}) {
        const double element = 2.0 / n, trim = 0.3 * element;
        const SlantedEdge edge(n, trim, trim), fine(4 * n, trim, trim);
        const CurveInterface to = edge.interface(), from = fine.interface();
        // Control values of a fine patch are the field but for its curvature, h^2.
        const Eigen::VectorXd values = smooth(from.coordinates());
        const double beside =
            errors(edge, MortarMapping(from, to, with(SingularMass::gradientTerm)).apply(values), 0,
                   element)
                .beside;
        if (before > 0) {
            EXPECT_LT(beside, before / 2.6) << n; // order 2: 4 in the limit; order 1: 2
        }
        before = beside;
    }
}

TEST(GradientTerm, continues_fields_over_what_trimming_leaves_of_patches) {
    // Kept: [0, 1 + 2e-7] x [0, 1], a sliver of the third column of elements.
    const geometry::ParameterBox kept{{0, 0}, {0.5 + 1e-7, 1}};
    const SurfaceInterface to = onePatch(
        geometry::TrimmedPatch(plate(4, 4), {geometry::TrimmingLoop::around(kept)}, "trimmed"));
    const auto largestError = [&](const Points& mapped, const Points& expected) {
        int nActive = 0;
        double largest = 0;
        for (int i = 0; i < to.nValues(); ++i) {
            if (mapped.row(i).norm() > 0) {
                ++nActive;
                largest = std::max(largest, (mapped.row(i) - expected.row(i)).norm());
            }
        }
        EXPECT_EQ(nActive, 5 * 6); // biquadratic, three columns of elements, four rows
        return largest;
    };
    const SurfaceInterface from = onePatch(geometry::TrimmedPatch(plate(3, 5), "whole"));
    const MortarMapping mapping(from, to, with(SingularMass::gradientTerm));
    EXPECT_LT(mapping.report().rank, mapping.report().nInverted);
    EXPECT_LT(
        largestError(mapping.apply(linearField(from.coordinates())), linearField(to.coordinates())),
        1e-9);
    const SurfaceMesh mesh = flatMesh(8, 4, FaceKind::quadrilaterals, ValuesAt::vertices);
    const MortarMapping fromMesh(mesh, to, with(SingularMass::gradientTerm));
    const Points one = Points::Ones(mesh.nValues(), 3);
    EXPECT_LT(largestError(fromMesh.apply(one), Points::Ones(to.nValues(), 3)), 1e-9);
}

TEST(GradientTerm, numbers_of_a_patchs_control_points_do_not_matter) {
    const geometry::ParameterBox kept{{0, 0}, {0.5 + 1e-7, 1}};
    const geometry::TrimmedPatch trimmed(plate(4, 4), {geometry::TrimmingLoop::around(kept)});
    const int n = trimmed.basis().nControlPoints();
    std::vector<int> reversed(static_cast<std::size_t>(n));
    std::iota(reversed.rbegin(), reversed.rend(), 0);
    const SurfaceInterface to({{trimmed, reversed, "trimmed"}}, n);
    const SurfaceInterface from = onePatch(geometry::TrimmedPatch(plate(3, 5)));
    const Points mapped = MortarMapping(from, to, with(SingularMass::gradientTerm))
                              .apply(linearField(from.coordinates()));
    const Points expected = linearField(to.coordinates());
    for (Eigen::Index i = 0; i < mapped.rows(); ++i) {
        EXPECT_TRUE(mapped.row(i).norm() == 0 || (mapped - expected).row(i).norm() < 1e-9) << i;
    }
}

TEST(GradientTerm, keeps_rank_and_count_and_explains_itself) {
    const CurveInterface to = trimmedEdge(0.5), inside = trimmedEdge(0.3);
    const MortarMapping onKnotLine(verticalMesh(3), to, with(SingularMass::gradientTerm));
    EXPECT_EQ(onKnotLine.report().nInverted, 8);
    EXPECT_EQ(onKnotLine.report().rank, 4);
    const MortarMapping mapping(verticalMesh(3), inside, with(SingularMass::gradientTerm));
    EXPECT_EQ(mapping.report().nInverted, 12);
    EXPECT_EQ(mapping.report().rank, 4);
    EXPECT_NE(mapping.report().text().find("12 functions has only 4 dimensions"),
              std::string::npos);
    EXPECT_NE(mapping.report().text().find("chosen by the gradient term"), std::string::npos);
    EXPECT_NE(mapping.report().json().text().find("\"gradient term\""), std::string::npos);
}

TEST(GradientTerm, is_not_used_where_nothing_is_open) {
    const MortarMapping mapping(verticalMesh(7), verticalSpline(2, 4),
                                with(SingularMass::gradientTerm));
    EXPECT_TRUE(mapping.report().regularisation.empty());
    EXPECT_LT(mapping.report().rowSumError, 1e-12);
}

} // namespace tokay::mapper
