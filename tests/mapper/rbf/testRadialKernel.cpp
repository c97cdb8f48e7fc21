// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mappingProperties.hpp"
#include "mapper/rbf/RbfInterpolant.hpp"
#include "mapper/sampleMeshes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::mapper {

TEST(RadialKernel, has_the_published_values) {
    // Wendland 1995, table 1, for space: the polynomials at r = 1/2.
    EXPECT_DOUBLE_EQ(valueOf(RadialKernel::compactC2, 0.5), 3.0 / 16);
    EXPECT_DOUBLE_EQ(valueOf(RadialKernel::compactC4, 0.5), 20.75 / 192);
    EXPECT_DOUBLE_EQ(valueOf(RadialKernel::compactC6, 0.5), 15.25 / 256);
    for (const RadialKernel kernel :
         {RadialKernel::compactC2, RadialKernel::compactC4, RadialKernel::compactC6}) {
        EXPECT_EQ(valueOf(kernel, 0), 1);
        EXPECT_EQ(valueOf(kernel, 1), 0);
        EXPECT_EQ(valueOf(kernel, 7), 0);
    }
    EXPECT_DOUBLE_EQ(valueOf(RadialKernel::thinPlate, 2), 4 * std::log(2.0));
    EXPECT_EQ(valueOf(RadialKernel::thinPlate, 0), 0);
}

TEST(RbfInterpolant, sparse_and_dense_systems_have_one_solution) {
    const Points from =
        flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices, 2, 1, 0).coordinates();
    const Points to =
        flatMesh(6, 8, FaceKind::triangles, ValuesAt::vertices, 2, 1, 2).coordinates();
    const geometry::BoxTree tree(pointBoxes(from));
    const Points values = linearField(from).array().sin();
    const Points forces = linearField(to).array().cos();
    const double radius = 0.7;
    for (const RadialKernel kernel :
         {RadialKernel::compactC2, RadialKernel::compactC4, RadialKernel::compactC6}) {
        const auto dense = denseInterpolant(from, to, kernel, radius);
        const auto sparse = sparseInterpolant(from, to, tree, kernel, radius);
        // The kernel matrix's condition, up to 1e6, enlarges rounding.
        EXPECT_LT((sparse->apply(values) - dense->apply(values)).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_LT((sparse->applyTransposed(forces) - dense->applyTransposed(forces))
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-9 * forces.norm());
    }
}

} // namespace tokay::mapper
