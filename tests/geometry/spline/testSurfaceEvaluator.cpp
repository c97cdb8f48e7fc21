// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/SurfaceEvaluator.hpp"
#include "geometry/spline/refinement.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

TEST(SurfaceEvaluator, agrees_with_the_surface_in_any_order_of_places) {
    const NurbsSurface polynomial = refine(rectangle(Point::Zero(), 2, 1), 3, 1, 4, 5);
    for (const NurbsSurface& surface : {sampleSurface(), polynomial}) {
        SurfaceEvaluator evaluator(surface);
        for (int k = 0; k < 200; ++k) {
            const double xi = (37 * k % 101) / 100.0, eta = (53 * k % 103) / 102.0;
            evaluator.moveTo(xi, eta);
            const SurfaceBasis basis = surface.basis(xi, eta, 1);
            const Points d = surface.derivatives(xi, eta, 1);
            EXPECT_EQ(evaluator.controlPoints(), basis.controlPoints);
            EXPECT_LT((evaluator.N().transpose() - basis.N.row(0)).norm(), 1e-14);
            EXPECT_LT((evaluator.point().transpose() - d.row(0)).norm(), 1e-13);
            EXPECT_LT((evaluator.tangentXi().transpose() - d.row(1)).norm(), 1e-12);
            EXPECT_LT((evaluator.tangentEta().transpose() - d.row(2)).norm(), 1e-12);
        }
    }
}

TEST(SurfaceEvaluator, jacobian_of_a_rectangle_is_its_area) {
    const NurbsSurface surface = rectangle(Point(3, 4, 5), 2, 0.5);
    SurfaceEvaluator evaluator(surface);
    evaluator.moveTo(0.3, 1);
    EXPECT_NEAR(evaluator.jacobian(), 1, 1e-14);
}

} // namespace tokay::geometry
