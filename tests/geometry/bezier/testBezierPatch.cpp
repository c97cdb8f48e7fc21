// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/BezierPatch.hpp"
#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/sampleGeometry.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

TEST(BezierPatch, has_the_derivatives_of_the_surface) {
    const NurbsSurface rational = sampleSurface();
    const NurbsSurface polynomial(rational.u(), rational.v(), rational.controlPoints());
    for (const NurbsSurface& surface : {rational, polynomial}) {
        for (const NurbsSurface& piece : bezierPieces(surface)) {
            const BezierPatch patch(piece);
            // Second derivatives are sums of terms of the size p (p - 1) / length^2
            // times a coordinate, each rounded a few times.
            const double length = (patch.upper() - patch.lower()).minCoeff();
            const double rounding =
                4e-15 * 6 / (length * length) * piece.controlPoints().cwiseAbs().maxCoeff();
            for (const double s : sampleParameters(4)) {
                for (const double t : sampleParameters(4)) {
                    const Eigen::Vector2d at = patch.lower() + Eigen::Vector2d(s, t).cwiseProduct(
                                                                   patch.upper() - patch.lower());
                    const Points expected = piece.derivatives(at[0], at[1], 2);
                    EXPECT_LT((patch.derivatives(at) - expected).cwiseAbs().maxCoeff(), rounding);
                }
            }
        }
    }
}

TEST(BezierPatch, linear_patches_have_no_second_derivative) {
    Points points(4, 3);
    points << 0, 0, 0, 1, 0, 0, 0, 2, 0, 1.5, 2, 1;
    const BezierPatch patch(
        NurbsSurface(KnotVector::uniform(1, 1), KnotVector::uniform(1, 1), points));
    const BezierPatch::Derivatives d = patch.derivatives({0.3, 0.6});
    EXPECT_EQ(d.row(3).norm(), 0);
    EXPECT_EQ(d.row(5).norm(), 0);
    EXPECT_LT((d.row(4) - Eigen::RowVector3d(0.5, 0, 1)).norm(), 1e-15);
}

} // namespace tokay::geometry
