// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/expectPatchTest.hpp"
#include "mapper/samplePatches.hpp"

#include <Eigen/QR>

#include <cmath>

namespace tokay::mapper {

namespace {

using geometry::TrimmedPatch;

double smooth(const Point& x) {
    return std::sin(3 * x[2] + 0.3) * std::cos(2 * x[0]) + x[1];
}

/// Quarter of a cylinder of radius 1 and height 1.
SurfaceInterface quarterCylinder(int degree, int nAround, int nAlong) {
    return onePatch(
        TrimmedPatch(refine(geometry::cylinderPatch(Point::Zero(), 1, 1, 0, std::acos(0.0)), degree,
                            degree, nAround, nAlong)));
}

/// Places spread over the patch, and the smooth field's error there.
struct Samples {
    Eigen::MatrixXd functions;
    Eigen::VectorXd exact;

    Samples(const SurfaceInterface& splines, int n)
        : functions(Eigen::MatrixXd::Zero(n * n, splines.nValues())), exact(n * n) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const double xi = (i + 0.5) / n, eta = (j + 0.5) / n;
                const Functions at = splines.functions(0, xi, eta);
                for (std::size_t k = 0; k < at.values.size(); ++k) {
                    functions(i + n * j, at.values[k]) = at.weights[k];
                }
                exact[i + n * j] = smooth(splines.piece(0).patch.basis().point(xi, eta));
            }
        }
    }
    double error(const Eigen::VectorXd& values) const {
        return (functions * values - exact).norm() / std::sqrt(static_cast<double>(exact.size()));
    }
};

} // namespace

TEST(SplineMortar, passes_the_patch_test_between_patches_that_do_not_match) {
    const SurfaceInterface even = onePatch(TrimmedPatch(plate(5, 4)));
    const SurfaceInterface bent = onePatch(TrimmedPatch(bentParameters(6, 4)));
    expectPatchTest(even, bent);
    expectPatchTest(bent, even);
    expectPatchTest(twoPatches(), even);
    expectPatchTest(even, twoPatches());
    EXPECT_NEAR(MortarMapping(even, twoPatches()).report().coverage, 1, 1e-12);
    EXPECT_NEAR(MortarMapping(even, twoPatches()).massMatrix().sum(), 2, 1e-13);
}

TEST(SplineMortar, passes_the_patch_test_between_trimmed_patches) {
    MortarOptions options;
    options.singular = SingularMass::minimumNorm;
    expectPatchTest(onePatch(holedPlate(5, 4)), onePatch(holedPlate(7, 6)), options);
    expectPatchTest(twoPatches(), onePatch(holedPlate()), options);
    expectPatchTest(onePatch(holedPlate()), twoPatches(), options);
    // Where the source has its hole the destination gets nothing.
    const MortarMapping mapping(onePatch(holedPlate()), twoPatches(), options);
    const double hole = std::acos(-1.0) * 2 * 0.23 * 0.23;
    EXPECT_NEAR(mapping.report().coverage, 1 - hole / 2, 2e-4); // the chords of the hole
}

TEST(SplineMortar, parts_of_the_destination_beyond_the_source_are_left_out_and_counted) {
    const SurfaceInterface half =
        onePatch(TrimmedPatch(refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 3, 3)));
    MortarOptions options;
    options.singular = SingularMass::minimumNorm;
    const SurfaceInterface whole = onePatch(TrimmedPatch(plate(5, 4)));
    expectPatchTest(half, whole, options);
    const MortarMapping mapping(half, whole, options);
    EXPECT_NEAR(mapping.report().coverage, 0.5, 1e-12);
    EXPECT_GT(mapping.report().nUncovered, 0);
    EXPECT_NEAR(mapping.massMatrix().sum(), 1, 1e-13);
}

TEST(SplineMortar, is_at_least_of_the_degree_plus_one_on_curved_patches) {
    const SurfaceInterface from = quarterCylinder(6, 8, 8);
    const Samples fine(from, 30);
    const Eigen::VectorXd values = fine.functions.householderQr().solve(fine.exact);
    ASSERT_LT(fine.error(values), 2e-7) << "the source's own error";
    for (int degree = 2; degree <= 3; ++degree) {
        double coarser = 0, order = 0;
        for (const int n : {3, 6, 12}) {
            const SurfaceInterface to = quarterCylinder(degree, n, n);
            const double error = Samples(to, 50).error(MortarMapping(from, to).apply(values));
            order = std::log2(coarser / error);
            coarser = error;
        }
        EXPECT_GT(order, degree + 0.75); // coarse patches are not yet on the slope
    }
}

TEST(SplineMortar, keeps_constants_and_forces_on_curved_patches) {
    const SurfaceInterface from = quarterCylinder(2, 5, 3), to = quarterCylinder(3, 4, 6);
    const MortarMapping mapping(from, to);
    EXPECT_LT(mapping.report().rowSumError, 1e-12);
    EXPECT_LT(mapping.report().forceSumError, 1e-12);
    EXPECT_LT(mapping.report().momentError, 1e-12); // both hold the linear field
    EXPECT_GT(mapping.report().coverage, 0.999);
    expectTransposesEqual(mapping, from.nValues(), to.nValues());
}

TEST(SplineMortar, the_dual_basis_is_refused) {
    MortarOptions options;
    options.basis = MortarBasis::dual;
    expectInputError([&] { MortarMapping(twoPatches(), twoPatches(), options); }, {"dual basis"});
}

} // namespace tokay::mapper
