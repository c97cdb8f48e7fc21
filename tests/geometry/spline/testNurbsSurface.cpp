// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/NurbsSurface.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

TEST(NurbsSurface, rational_functions_sum_to_one_and_their_derivatives_to_zero) {
    const NurbsSurface surface = sampleSurface();
    for (const double xi : sampleParameters(9)) {
        for (const double eta : sampleParameters(9)) {
            const SurfaceBasis basis = surface.basis(xi, eta, 3);
            EXPECT_NEAR(basis.N.row(0).sum(), 1, 1e-14);
            for (int row = 1; row < nDerivativeRows(3); ++row) {
                EXPECT_NEAR(basis.N.row(row).sum(), 0, 1e-13 * basis.N.row(row).norm());
            }
        }
    }
}

TEST(NurbsSurface, derivatives_of_any_order_agree_with_finite_differences) {
    const NurbsSurface surface = sampleSurface();
    const double h = 1e-5; // error h^2 and 1e-16 / h of each derivative's scale
    for (const double xi : {0.2, 0.77}) {
        for (const double eta : {0.13, 0.61, 0.9}) {
            const Points exact = surface.derivatives(xi, eta, 4);
            const double scale = exact.rowwise().norm().maxCoeff();
            const Points byXi =
                (surface.derivatives(xi + h, eta, 3) - surface.derivatives(xi - h, eta, 3)) /
                (2 * h);
            const Points byEta =
                (surface.derivatives(xi, eta + h, 3) - surface.derivatives(xi, eta - h, 3)) /
                (2 * h);
            for (int n = 0; n <= 3; ++n) {
                for (int l = 0; l <= n; ++l) {
                    const int k = n - l, row = derivativeRow(k, l);
                    EXPECT_LT((byXi.row(row) - exact.row(derivativeRow(k + 1, l))).norm(),
                              1e-6 * scale);
                    EXPECT_LT((byEta.row(row) - exact.row(derivativeRow(k, l + 1))).norm(),
                              1e-6 * scale);
                }
            }
        }
    }
}

TEST(NurbsSurface, boundary_curves_lie_on_the_surface_and_know_their_control_points) {
    const NurbsSurface surface = sampleSurface();
    for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
        const BoundaryCurve boundary = surface.boundaryCurve(edge);
        for (const double t : sampleParameters(17)) {
            const double xi = edge == Edge::left ? 0 : edge == Edge::right ? 1 : t;
            const double eta = edge == Edge::bottom ? 0 : edge == Edge::top ? 1 : t;
            EXPECT_LT((boundary.curve.point(t) - surface.point(xi, eta)).norm(), 1e-14 * 5)
                << nameOf(edge) << " at " << t;
        }
        for (int i = 0; i < boundary.curve.nControlPoints(); ++i) {
            EXPECT_EQ(boundary.curve.controlPoints().row(i),
                      surface.controlPoints().row(boundary.controlPoints[i]));
        }
    }
}

TEST(NurbsSurface, edges_have_names_and_a_wrong_name_is_refused_with_the_list) {
    for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
        EXPECT_EQ(edgeFromName(nameOf(edge)), edge);
    }
    expectInputError([] { edgeFromName("upper"); }, {"upper", "left", "right", "bottom", "top"});
}

} // namespace tokay::geometry
