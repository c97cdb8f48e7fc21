// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/sampleVolume.hpp"
#include "geometry/spline/NurbsVolume.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace tokay::geometry {

namespace {

// Coordinates are of size 6; a point is a sum of some dozen products.
constexpr double rounding = 2e-14;

std::vector<Eigen::Vector3d> places() {
    std::vector<Eigen::Vector3d> all;
    for (const double zeta : sampleParameters(5)) {
        for (const double eta : sampleParameters(5)) {
            for (const double xi : sampleParameters(7)) {
                all.emplace_back(xi, eta, zeta);
            }
        }
    }
    return all;
}

void expectSameVolume(const NurbsVolume& a, const NurbsVolume& b) {
    for (const Eigen::Vector3d& at : places()) {
        EXPECT_LT((a.point(at) - b.point(at)).norm(), rounding) << at.transpose();
    }
}

} // namespace

TEST(NurbsVolume, functions_sum_to_one_and_their_derivatives_to_zero) {
    for (const Eigen::Vector3d& at : places()) {
        const VolumeBasis basis = sampleVolume().basis(at);
        EXPECT_GE(basis.N.row(0).minCoeff(), 0);
        EXPECT_NEAR(basis.N.row(0).sum(), 1, 1e-14);
        EXPECT_LT(basis.N.bottomRows<3>().rowwise().sum().norm(),
                  1e-12); // derivatives are up to 10
    }
}

TEST(NurbsVolume, affine_map_of_control_points_is_the_map_of_points) {
    const NurbsVolume volume = sampleVolume();
    Eigen::Matrix3d A;
    A << 1, 2, 0.5, -1, 0.3, 2, 0, 1, -2;
    const Eigen::RowVector3d shift(3, -2, 1);
    const Points moved = (volume.controlPoints() * A.transpose()).rowwise() + shift;
    const NurbsVolume image(volume.u(), volume.v(), volume.w(), moved, volume.weights());
    for (const Eigen::Vector3d& at : places()) {
        const Point expected = A * volume.point(at) + shift.transpose();
        EXPECT_LT((image.point(at) - expected).norm(), 5 * rounding);
    }
}

TEST(NurbsVolume, jacobian_is_the_derivative_of_the_point) {
    const NurbsVolume volume = sampleVolume();
    const Eigen::Vector3d at(0.3, 0.62, 0.4);
    const double h = 1e-5; // truncation h^2, rounding 1e-15 / h: both 1e-10
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(axis);
        const Point difference = (volume.point(at + step) - volume.point(at - step)) / (2 * h);
        EXPECT_LT((volume.jacobian(at).col(axis) - difference).norm(), 1e-8);
    }
}

TEST(NurbsVolume, refinement_leaves_a_rational_volume_unchanged) {
    const NurbsVolume volume = sampleVolume();
    expectSameVolume(volume, insertKnots(volume, {{{0.1, 0.3, 0.3}, {0.7}, {0.2, 0.9}}}));
    expectSameVolume(volume, elevateDegree(volume, {1, 0, 2}));
    const NurbsVolume fine = refine(volume, {3, 4, 2}, {2, 1, 3});
    EXPECT_EQ(fine.u().degree(), 3);
    EXPECT_EQ(fine.v().degree(), 4);
    EXPECT_EQ(fine.w().degree(), 2);
    EXPECT_EQ(fine.u().nSpans(), 2 * volume.u().nSpans());
    EXPECT_EQ(fine.w().nSpans(), 3 * volume.w().nSpans());
    expectSameVolume(volume, fine);
}

TEST(NurbsVolume, sides_are_its_points_and_know_where_outside_is) {
    const NurbsVolume volume = sampleVolume();
    for (int number = 0; number < 6; ++number) {
        const Side side = static_cast<Side>(number);
        EXPECT_EQ(sideFromName(nameOf(side)), side);
        const BoundarySurface boundary = volume.boundarySurface(side);
        const int axis = number / 2;
        Eigen::Vector3d at(0.35, 0.55, 0.75);
        at[axis] = number % 2;
        const double xi = at[axis == 0 ? 1 : 0], eta = at[axis == 2 ? 1 : 2];
        const Points d = boundary.surface.derivatives(xi, eta, 1);
        EXPECT_LT((d.row(0).transpose() - volume.point(at)).norm(), rounding);
        for (std::size_t k = 0; k < boundary.controlPoints.size(); ++k) {
            EXPECT_EQ(boundary.surface.controlPoints().row(k),
                      volume.controlPoints().row(boundary.controlPoints[k]));
        }
        const Point normal = Point(d.row(1)).cross(Point(d.row(2)));
        const Point outwards = (number % 2 == 1 ? 1 : -1) * volume.jacobian(at).col(axis);
        EXPECT_EQ(normal.dot(outwards) > 0, boundary.pointsOutwards) << nameOf(side);
    }
}

TEST(NurbsVolume, thickened_cylinder_is_exact) {
    const NurbsVolume ring = thickened(cylinderPatch({1, 2, 3}, 1.5, 2, 0.2, 3), 1);
    for (const Eigen::Vector3d& at : places()) {
        const Point x = ring.point(at) - Point(1, 2, 3);
        EXPECT_NEAR(x.head<2>().norm(), 1 + at[2], rounding);
        EXPECT_NEAR(x[2], 2 * at[1], rounding);
        EXPECT_GT(ring.jacobian(at).determinant(), 0);
    }
}

TEST(NurbsVolume, block_is_where_it_shall_be) {
    const NurbsVolume box = block({1, 2, 3}, {4, 5, 6});
    EXPECT_LT((box.point({0.5, 0.2, 1}) - Point(3, 3, 9)).norm(), rounding);
    EXPECT_NEAR(box.jacobian({0.1, 0.2, 0.3}).determinant(), 120, 1e-12);
}

TEST(NurbsVolume, wrong_input_is_refused) {
    const KnotVector linear = KnotVector::uniform(1, 1);
    expectInputError([&] { NurbsVolume(linear, linear, linear, Points::Zero(7, 3)); }, {"8", "7"});
    expectInputError([] { block({0, 0, 0}, {1, 1, 0}); }, {"along z is 0", "positive"});
    expectInputError(
        [] {
            thickened(plate({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), -1);
        },
        {"thickness is -1"});
    expectInputError([] { thickened(sampleSurface(), 0.1); }, {"cannot be thickened exactly"});
    expectInputError([] { sideFromName("middle"); }, {"middle", "left, right, bottom, top"});
}

} // namespace tokay::geometry
