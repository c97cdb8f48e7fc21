// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/primitives.hpp"
#include "geometry/projection/CurveProjector.hpp"
#include "geometry/projection/SurfaceProjector.hpp"
#include "geometry/sampleGeometry.hpp"
#include "geometry/spline/refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::geometry {

namespace {

const double pi = std::acos(-1.0);

Point normalised(const Point& a) {
    return a / a.norm();
}
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Sphere as a surface of revolution: a seam and two poles.
NurbsSurface sphere(double radius) {
    const NurbsCurve meridian = arc(Point::Zero(), radius, -pi / 2, pi / 2);
    const NurbsCurve parallel = arc(Point::Zero(), 1, 0, 2 * pi);
    const int nU = parallel.nControlPoints(), nV = meridian.nControlPoints();
    Points points(nU * nV, 3);
    Eigen::VectorXd weights(nU * nV);
    for (int j = 0; j < nV; ++j) {
        for (int i = 0; i < nU; ++i) {
            const double r = meridian.controlPoints()(j, 0), z = meridian.controlPoints()(j, 1);
            points.row(i + nU * j) << r * parallel.controlPoints()(i, 0),
                r * parallel.controlPoints()(i, 1), z;
            weights[i + nU * j] = meridian.weights()[j] * parallel.weights()[i];
        }
    }
    return NurbsSurface(parallel.knotVector(), meridian.knotVector(), points, weights);
}

} // namespace

TEST(CurveProjector, finds_the_parameter_of_points_on_the_curve) {
    const NurbsCurve curve = sampleCurve();
    const CurveProjector projector(curve);
    for (const double xi : sampleParameters(301)) {
        const CurveProjection found = projector.closest(curve.point(xi));
        EXPECT_TRUE(found.converged);
        EXPECT_FALSE(found.ambiguous);
        EXPECT_NEAR(found.xi, xi, 1e-13);
        EXPECT_LT(found.distance, 1e-14 * 6);
    }
}

TEST(CurveProjector, offset_is_normal_to_the_curve) {
    const NurbsCurve curve = sampleCurve();
    const CurveProjector projector(curve);
    for (const double xi : sampleParameters(101)) {
        // 0.05 is well below the curve's radii of curvature.
        const Points d = curve.derivatives(xi, 1);
        const Point normal = normalised(cross(d.row(1), Point(0.3, 0.2, 1)));
        const CurveProjection found = projector.closest(d.row(0).transpose() + 0.05 * normal);
        EXPECT_TRUE(found.converged);
        EXPECT_NEAR(found.xi, xi, 1e-11);
        EXPECT_NEAR(found.distance, 0.05, 1e-14);
    }
}

TEST(CurveProjector, never_misses_a_nearer_place_of_the_curve) {
    const NurbsCurve curve = sampleCurve();
    const CurveProjector projector(curve);
    for (int i = 0; i < 500; ++i) {
        const Point point(7 * std::sin(1.0 * i), 3 * std::cos(2.3 * i), 2 * std::sin(3.7 * i));
        const CurveProjection found = projector.closest(point);
        double nearest = 1e300;
        for (const double xi : sampleParameters(2001)) {
            nearest = std::min(nearest, (curve.point(xi) - point).norm());
        }
        EXPECT_TRUE(found.converged);
        EXPECT_LE(found.distance, nearest + 1e-14);
        EXPECT_NEAR((curve.point(found.xi) - point).norm(), found.distance, 1e-13);
    }
}

TEST(CurveProjector, points_beyond_an_end_or_a_corner_get_the_end_or_the_corner) {
    const CurveProjector projector(curveWithCorner());
    EXPECT_EQ(projector.closest(Point(-1, -0.5, 0)).xi, 0);
    EXPECT_EQ(projector.closest(Point(3, 4, 0)).xi, 1);
    const CurveProjection corner = projector.closest(Point(2.3, -0.3, 0));
    EXPECT_EQ(corner.xi, 0.5);
    EXPECT_TRUE(corner.converged);
    EXPECT_FALSE(corner.ambiguous) << "both sides of a corner are one place";
    EXPECT_NEAR(corner.distance, std::hypot(0.3, 0.3), 1e-15);
}

TEST(CurveProjector, both_sides_of_a_corner_are_found_next_to_it) {
    const NurbsCurve curve = curveWithCorner();
    const CurveProjector projector(curve);
    for (const double distance : {1e-12, 1e-9, 1e-6, 1e-3}) {
        for (const double xi : {0.5 - distance, 0.5 + distance}) {
            EXPECT_NEAR(projector.closest(curve.point(xi)).xi, xi, 1e-15 * 5);
        }
    }
}

TEST(CurveProjector, the_centre_of_a_circle_is_ambiguous_and_its_neighbour_is_not) {
    const CurveProjector projector(arc(Point(1, 1, 0), 2, 0, 2 * pi));
    const CurveProjection centre = projector.closest(Point(1, 1, 0));
    EXPECT_TRUE(centre.ambiguous);
    EXPECT_NEAR(centre.distance, 2, 1e-15 * 4);
    const CurveProjection beside = projector.closest(Point(1.01, 1, 0));
    EXPECT_FALSE(beside.ambiguous);
    EXPECT_NEAR(beside.distance, 1.99, 1e-15 * 8);
}

TEST(CurveProjector, a_place_that_newtons_method_does_not_meet_is_told_from_one_that_it_meets) {
    const CurveProjector projector(parabola());
    const CurveProjection atCentre = projector.closest(Point(0, 0.5, 0));
    EXPECT_FALSE(atCentre.converged);
    EXPECT_FALSE(atCentre.ambiguous);
    // The nearest place is the vertex; the distance has what is left of x to the power of 4.
    EXPECT_NEAR(atCentre.xi, 1.0 / 3, 0.01);
    EXPECT_NEAR(atCentre.distance, 0.5, 1e-6);
    const CurveProjection below = projector.closest(Point(0, 0.4, 0));
    EXPECT_TRUE(below.converged);
    EXPECT_NEAR(below.xi, 1.0 / 3, 1e-11); // tolerance over the curvature, 0.2
}

TEST(CurveProjector, scale_and_position_do_not_matter) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double offset : {0.0, 1e6}) {
            const Point shift = scale * offset * Point(1, -1, 0.5);
            const NurbsCurve sample = sampleCurve();
            const NurbsCurve curve = sample.withControlPoints(
                (scale * sample.controlPoints()).rowwise() + shift.transpose());
            const CurveProjector projector(curve);
            // Coordinates of size 1e6 times the curve's carry an error of 1e-10.
            const double error = offset > 0 ? 1e-9 : 1e-13;
            for (const double xi : sampleParameters(51)) {
                const CurveProjection found = projector.closest(curve.point(xi));
                EXPECT_TRUE(found.converged);
                EXPECT_NEAR(found.xi, xi, error);
                EXPECT_LT(found.distance, 10 * error * scale);
            }
        }
    }
}

TEST(SurfaceProjector, finds_the_parameters_of_points_on_the_surface) {
    const NurbsSurface surface = sampleSurface();
    const SurfaceProjector projector(surface);
    for (const double xi : sampleParameters(31)) {
        for (const double eta : sampleParameters(31)) {
            const SurfaceProjection found = projector.closest(surface.point(xi, eta));
            EXPECT_TRUE(found.converged);
            EXPECT_FALSE(found.ambiguous);
            EXPECT_NEAR(found.xi, xi, 1e-13);
            EXPECT_NEAR(found.eta, eta, 1e-13);
            EXPECT_LT(found.distance, 1e-13);
        }
    }
}

TEST(SurfaceProjector, never_misses_a_nearer_place_of_the_surface) {
    const NurbsSurface surface = sampleSurface();
    const SurfaceProjector projector(surface);
    for (int i = 0; i < 100; ++i) {
        const Point point(4 * std::sin(1.0 * i), 6 * std::cos(2.3 * i), 2 * std::sin(3.7 * i));
        const SurfaceProjection found = projector.closest(point);
        double nearest = 1e300;
        for (const double xi : sampleParameters(101)) {
            for (const double eta : sampleParameters(101)) {
                nearest = std::min(nearest, (surface.point(xi, eta) - point).norm());
            }
        }
        EXPECT_TRUE(found.converged);
        EXPECT_LE(found.distance, nearest + 1e-13);
        EXPECT_NEAR((surface.point(found.xi, found.eta) - point).norm(), found.distance, 1e-12);
    }
}

TEST(SurfaceProjector, a_sphere_is_found_at_its_seam_and_its_poles_too) {
    const SurfaceProjector projector(sphere(2));
    for (const double latitude : {-pi / 2, -1.5, -0.3, 0.0, 1.2, pi / 2 - 1e-7, pi / 2}) {
        for (const double longitude : {0.0, 1e-9, -1e-9, 2.0, pi}) {
            for (const double radius : {1.9, 2.0, 3.0}) {
                const Point direction(std::cos(latitude) * std::cos(longitude),
                                      std::cos(latitude) * std::sin(longitude), std::sin(latitude));
                const SurfaceProjection found = projector.closest(radius * direction);
                EXPECT_TRUE(found.converged) << latitude << " " << longitude << " " << radius;
                EXPECT_FALSE(found.ambiguous) << latitude << " " << longitude << " " << radius;
                EXPECT_NEAR(found.distance, std::abs(radius - 2), 1e-14);
            }
        }
    }
    EXPECT_TRUE(projector.closest(Point::Zero()).ambiguous);
}

TEST(SurfaceProjector, a_place_that_newtons_method_does_not_meet_is_told_from_one_that_it_meets) {
    const SurfaceProjector projector(parabolicCylinder());
    const SurfaceProjection atCentre = projector.closest(Point(0, 0.5, 0.3));
    EXPECT_FALSE(atCentre.converged);
    EXPECT_NEAR(atCentre.xi, 1.0 / 3, 0.01); // as of the parabola
    EXPECT_NEAR(atCentre.eta, 0.3, 1e-9);
    EXPECT_NEAR(atCentre.distance, 0.5, 1e-6);
    EXPECT_TRUE(projector.closest(Point(0, 0.4, 0.3)).converged);
}

TEST(SurfaceProjector, a_thin_and_an_anisotropic_patch_are_found) {
    const NurbsSurface patch = refine(rectangle(Point(5, 5, 0), 1, 1e-3), 2, 2, 3, 40);
    const SurfaceProjector projector(patch);
    for (const double xi : sampleParameters(13)) {
        for (const double eta : sampleParameters(13)) {
            const SurfaceProjection found =
                projector.closest(patch.point(xi, eta) + Point(0, 0, 0.1));
            EXPECT_TRUE(found.converged);
            EXPECT_NEAR(found.xi, xi, 1e-14);
            EXPECT_NEAR(found.eta, eta, 5e-12); // y = 5 is rounded to 1e-12 of the width
            EXPECT_NEAR(found.distance, 0.1, 1e-14);
        }
    }
}

} // namespace tokay::geometry
