// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/primitives.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/nearest/SplineSamples.hpp"
#include "mapper/sampleInterfaces.hpp"
#include "mapper/samplePatches.hpp"

#include <gtest/gtest.h>

namespace tokay::mapper {

TEST(SplineSamples, hold_shared_corners_and_edges_once) {
    // 14 spans of degree 2 along each side, 4 functions along the top; two corners are shared.
    const SplineSamples onCurves = splineSamples(flapInterface());
    EXPECT_EQ(onCurves.points.rows(), 14 + 4 + 14 - 2);
    // 4 x 5 and 5 x 5 functions, of which 5 are shared.
    EXPECT_EQ(splineSamples(twoPatches()).points.rows(), 20 + 25 - 5);
}

TEST(SplineSamples, leave_out_what_trimming_leaves_out) {
    const geometry::TrimmedPatch patch = holedPlate();
    const SplineSamples samples = splineSamples(onePatch(patch));
    EXPECT_LT(samples.points.rows(), patch.basis().nControlPoints());
    for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
        // Parameters are x / 2 and y; the hole is a circle there.
        const double distance =
            std::hypot(samples.points(i, 0) / 2 - 0.45, samples.points(i, 1) - 0.55);
        EXPECT_GE(distance, 0.23 - 1e-12);
    }
}

TEST(SplineSamples, functions_reproduce_linear_fields_at_the_points) {
    for (const SurfaceInterface& splines : {twoPatches(), onePatch(holedPlate())}) {
        const SplineSamples samples = splineSamples(splines);
        const Points field = samples.functions * linearField(splines.coordinates());
        EXPECT_LT((field - linearField(samples.points)).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(SplineSamples, hold_a_corner_once_whose_pieces_differ_by_rounding_and_close_points_each) {
    const auto line = [](double from, double to) {
        return geometry::line(Point(from, 0, 0), Point(to, 0, 0));
    };
    const SplineInterface corner(
        {{line(0, 1), {0, 1}, "first"}, {line(1 + 1e-13, 2), {1, 2}, "second"}}, 3);
    EXPECT_EQ(splineSamples(corner).points.rows(), 3);
    EXPECT_EQ(splineSamples(verticalSpline(1, 500)).points.rows(), 501);
}

} // namespace tokay::mapper
