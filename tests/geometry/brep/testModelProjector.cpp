// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/ModelProjector.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/sampleLoops.hpp"
#include "geometry/sampleModels.hpp"
#include "geometry/spline/refinement.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

const double pi = std::acos(-1.0);

Point normalOf(const NurbsSurface& surface, double xi, double eta) {
    const Points d = surface.derivatives(xi, eta, 1);
    return Point(d.row(1)).cross(Point(d.row(2))).normalized();
}

/// Roof of two plates that meet at the ridge y = 0, z = 1.
BrepModel roof() {
    return BrepModel(
        {{TrimmedPatch(plate(Point(0, -1, 0), Point(2, 0, 0), Point(0, 1, 1)), "south")},
         {TrimmedPatch(plate(Point(0, 0, 1), Point(2, 0, 0), Point(0, 1, -1)), "north")}});
}

} // namespace

TEST(ModelProjector, finds_the_foot_of_points_above_every_face) {
    const BrepModel model = twoSquares(0.1);
    const ModelProjector projector(model);
    for (int face = 0; face < 2; ++face) {
        for (const double xi : sampleParameters(21)) {
            for (const double eta : sampleParameters(21)) {
                if (!model.patch(face).contains({xi, eta})) {
                    continue;
                }
                const Point foot = model.patch(face).surface().point(xi, eta);
                const ModelProjection found = projector.closest(foot + Point(0, 0, 0.04));
                EXPECT_TRUE(found.converged);
                EXPECT_NEAR(found.distance, 0.04, 1e-15);
                EXPECT_EQ(found.face, face);
                EXPECT_NEAR(found.xi, xi, 1e-14);
                EXPECT_NEAR(found.eta, eta, 1e-14);
            }
        }
    }
}

TEST(ModelProjector, points_over_a_hole_get_its_rim) {
    const BrepModel model = twoSquares(); // a hole of radius 0.25 at (0.5, 0.5)
    const ModelProjector projector(model);
    for (const double radius : {0.01, 0.1, 0.2, 0.2499999}) {
        for (const double angle : sampleParameters(17)) {
            for (const double height : {0.0, 0.3}) {
                const Point direction(std::cos(6 * angle), std::sin(6 * angle), 0);
                const Point point = Point(0.5, 0.5, height) + radius * direction;
                const ModelProjection found = projector.closest(point);
                EXPECT_TRUE(found.converged);
                EXPECT_TRUE(found.isOnRim);
                EXPECT_FALSE(found.ambiguous) << radius;
                EXPECT_NEAR(found.distance, std::hypot(0.25 - radius, height), 1e-14);
                const Point place = model.patch(0).surface().point(found.xi, found.eta);
                EXPECT_LT((place - Point(0.5, 0.5, 0) - 0.25 * direction).norm(), 1e-11);
            }
        }
    }
    EXPECT_TRUE(projector.closest(Point(0.5, 0.5, 0.3)).ambiguous);
    const ModelProjection beyond = projector.closest(Point(-3, 0.5, 4));
    EXPECT_TRUE(beyond.isOnRim);
    EXPECT_NEAR(beyond.distance, 5, 1e-14);
}

TEST(ModelProjector, a_place_behind_what_is_trimmed_away_is_found) {
    // The nearest half of a sphere is trimmed away: its rim or the far half counts.
    const TrimmedPatch north(sphere(Point::Zero(), 1),
                             {polygonLoop(LoopKind::outer, {{0, 0.5}, {1, 0.5}, {1, 1}, {0, 1}})},
                             "north");
    const PatchProjector projector(north);
    const ModelProjection below = projector.closest(Point(0.1, 0, -2));
    EXPECT_TRUE(below.converged);
    EXPECT_TRUE(below.isOnRim);
    EXPECT_NEAR(below.distance, std::hypot(0.9, 2), 1e-14);
    EXPECT_TRUE(projector.closest(Point(0, 0, -2)).ambiguous) << "all of the equator";
    for (const double height : {0.5, 0.9, 1.7}) {
        const ModelProjection above =
            projector.closest(height * Point(0.1 * std::cos(1), 0.1 * std::sin(1), 1));
        EXPECT_NEAR(above.distance, std::abs(1 - std::hypot(0.1, 1) * height), 1e-14);
        EXPECT_FALSE(above.isOnRim);
    }
}

TEST(ModelProjector, never_misses_a_nearer_place_of_a_trimmed_surface) {
    const TrimmedPatch patch(sampleSurface(), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.45),
                                               circleLoop(LoopKind::inner, {0.4, 0.5}, 0.2)});
    const PatchProjector projector(patch);
    std::vector<Point> places;
    for (const double xi : sampleParameters(101)) {
        for (const double eta : sampleParameters(101)) {
            if (patch.contains({xi, eta})) {
                places.push_back(patch.surface().point(xi, eta));
            }
        }
    }
    for (int i = 0; i < 200; ++i) {
        const Point point(4 * std::sin(1.0 * i), 6 * std::cos(2.3 * i), 2 * std::sin(3.7 * i));
        const ModelProjection found = projector.closest(point);
        double nearest = 1e300;
        for (const Point& place : places) {
            nearest = std::min(nearest, (place - point).norm());
        }
        EXPECT_TRUE(found.converged);
        EXPECT_LE(found.distance, nearest + 1e-13);
        EXPECT_NEAR((patch.surface().point(found.xi, found.eta) - point).norm(), found.distance,
                    1e-12);
        // Inside, or on the rim to rounding.
        const Parameters at(found.xi, found.eta);
        const double beyond = std::max((at - Parameters(0.5, 0.5)).norm() - 0.45,
                                       0.2 - (at - Parameters(0.4, 0.5)).norm());
        EXPECT_LT(beyond, 1e-12);
    }
}

TEST(ModelProjector, faces_that_meet_are_one_place_and_faces_that_do_not_are_two) {
    const BrepModel model = halfCylinders();
    const ModelProjector projector(model);
    for (const double angle : {0.0, pi, 0.3, 1e-9, -1e-9}) {
        for (const double radius : {0.5, 1.0, 2.0}) {
            const ModelProjection found =
                projector.closest(Point(radius * std::cos(angle), radius * std::sin(angle), 0.7));
            EXPECT_TRUE(found.converged);
            EXPECT_FALSE(found.ambiguous) << angle << " " << radius;
            EXPECT_NEAR(found.distance, std::abs(1 - radius), 1e-14);
        }
    }
    EXPECT_TRUE(projector.closest(Point(0, 0, 1)).ambiguous) << "the axis";

    const BrepModel sides({{TrimmedPatch(rectangle(Point(0, 0, 0), 1, 1), "lower")},
                           {TrimmedPatch(rectangle(Point(0, 0, 0.01), 1, 1), "upper")}});
    const ModelProjector between(sides);
    EXPECT_TRUE(between.closest(Point(0.4, 0.4, 0.005)).ambiguous);
    const ModelProjection upper = between.closest(Point(0.4, 0.4, 0.00501));
    EXPECT_FALSE(upper.ambiguous);
    EXPECT_EQ(upper.face, 1);
}

TEST(ModelProjector, points_beyond_a_ridge_get_the_ridge) {
    const BrepModel model = roof();
    const ModelProjector projector(model);
    for (const double y : {-0.3, 0.0, 0.2}) {
        const ModelProjection found = projector.closest(Point(1.2, y, 2));
        EXPECT_TRUE(found.converged);
        EXPECT_FALSE(found.ambiguous) << "both sides of a ridge are one place";
        EXPECT_TRUE(found.isOnRim);
        EXPECT_NEAR(found.distance, std::hypot(y, 1), 1e-14);
    }
    // Under the ridge, two places as near.
    EXPECT_TRUE(projector.closest(Point(1.2, 0, 0.6)).ambiguous);
    EXPECT_FALSE(projector.closest(Point(1.2, 0.01, 0.6)).ambiguous);
}

TEST(ModelProjector, whole_meshes_are_projected_to_rounding) {
    const BrepModel model({{TrimmedPatch(sphere(Point(1, 2, 3), 2), "ball")}});
    const NurbsSurface& surface = model.patch(0).surface();
    const int n = 40;
    Points points(n * n, 3);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double xi = (i + 0.5) / n, eta = (j + 0.5) / n;
            points.row(i + n * j) =
                surface.point(xi, eta) + 0.3 * std::sin(i + j) * normalOf(surface, xi, eta);
        }
    }
    const std::vector<ModelProjection> found = ModelProjector(model).closestOfAll(points);
    double residual = 0;
    for (int k = 0; k < n * n; ++k) {
        const double xi = (k % n + 0.5) / n, eta = (k / n + 0.5) / n;
        residual = std::max(
            residual, (surface.point(found[k].xi, found[k].eta) - surface.point(xi, eta)).norm());
    }
    EXPECT_LT(residual, 2e-12); // 1e-12 of the size, as Newton stops
    const ProjectionSummary all = summary(found);
    EXPECT_EQ(all.nPoints, n * n);
    EXPECT_EQ(all.nNotConverged, 0);
    EXPECT_EQ(all.nAmbiguous, 0);
    EXPECT_NEAR(all.largestDistance, 0.3, 1e-3); // the sine comes close to 1
    EXPECT_EQ(found[all.farthestPoint].distance, all.largestDistance);
}

TEST(ModelProjector, places_that_newtons_method_does_not_meet_are_counted) {
    // Above a cylinder whose centre line of curvature is x = 0, y = 0.5.
    const BrepModel model({{TrimmedPatch(parabolicCylinder(), "cylinder")}});
    Points points(5, 3);
    points << 0, 0.4, 0.2, 0, 0.5, 0.2, 0.3, 0.4, 0.5, 0, 0.5, 0.7, 0, 0.3, 0.9;
    const std::vector<ModelProjection> found = ModelProjector(model).closestOfAll(points);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(found[i].converged, i % 2 == 0) << i;
    }
    EXPECT_EQ(summary(found).nNotConverged, 2);
}

TEST(ModelProjector, a_rim_that_newtons_method_does_not_meet_is_told_from_one_that_it_meets) {
    const TrimmedPatch patch = plateBelowParabola();
    const PatchProjector projector(patch);
    const ModelProjection atCentre = projector.closest(Point(0, 0.5, 0));
    EXPECT_TRUE(atCentre.isOnRim);
    EXPECT_FALSE(atCentre.converged);
    EXPECT_NEAR(atCentre.distance, 0.5, 1e-6); // what is left of x to the power of 4
    const ModelProjection below = projector.closest(Point(0, 0.4, 0));
    EXPECT_TRUE(below.isOnRim);
    EXPECT_TRUE(below.converged);
}

TEST(ModelProjector, scale_and_position_do_not_matter) {
    for (const double scale : {1e-6, 1e6}) {
        for (const double offset : {0.0, 1e6}) {
            const Point shift = scale * offset * Point(1, -1, 0.5);
            const NurbsSurface sample = sampleSurface();
            const TrimmedPatch patch(
                sample.withControlPoints((scale * sample.controlPoints()).rowwise() +
                                         shift.transpose()),
                {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.45),
                 circleLoop(LoopKind::inner, {0.4, 0.5}, 0.2)});
            const PatchProjector projector(patch);
            // Coordinates of size 1e6 times the surface carry an error of 1e-10.
            const double error = offset > 0 ? 1e-8 : 1e-12;
            for (const double angle : sampleParameters(9)) {
                const Parameters direction(std::cos(5 * angle), std::sin(5 * angle));
                for (const double radius : {0.19, 0.21}) { // in the hole and beside it
                    const Parameters at = Parameters(0.4, 0.5) + radius * direction;
                    const ModelProjection found =
                        projector.closest(patch.surface().point(at[0], at[1]));
                    EXPECT_TRUE(found.converged);
                    EXPECT_EQ(found.isOnRim, radius < 0.2);
                    if (radius > 0.2) {
                        EXPECT_LT((Parameters(found.xi, found.eta) - at).norm(), error);
                    } else {
                        EXPECT_NEAR((Parameters(found.xi, found.eta) - Parameters(0.4, 0.5)).norm(),
                                    0.2, error);
                    }
                }
            }
        }
    }
}

} // namespace tokay::geometry
