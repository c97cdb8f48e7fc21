// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/primitives.hpp"

#include "common/errors.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>

namespace tokay::geometry {

namespace {

constexpr double pi = 3.14159265358979323846;

void checkPositive(double value, const char* name) {
    if (!(value > 0) || !std::isfinite(value)) {
        throw InputError(fmt::format("the {} is {}: it must be positive", name, value));
    }
}

KnotVector linear() {
    return KnotVector::uniform(1, 1);
}

/// Unit arc as weights and control points (cos, sin), and its knots.
struct UnitArc {
    KnotVector knots;
    Eigen::MatrixX2d points;
    Eigen::VectorXd weights;
};

/// Source: Piegl & Tiller, The NURBS Book, algorithm A7.1, with equal spans
UnitArc unitArc(double startAngle, double endAngle) {
    const double angle = endAngle - startAngle;
    checkPositive(angle, "arc's angle (end minus start)");
    if (angle > 2 * pi * (1 + 1e-12)) {
        throw InputError(fmt::format("an arc of {} rad is more than a full turn", angle));
    }
    const int nSpans = std::max(1, static_cast<int>(std::ceil(angle / (pi / 2) * (1 - 1e-12))));
    const double half = angle / nSpans / 2;

    std::vector<double> knots(3, 0.0);
    for (int i = 1; i < nSpans; ++i) {
        knots.insert(knots.end(), 2, static_cast<double>(i) / nSpans);
    }
    knots.insert(knots.end(), 3, 1.0);

    UnitArc arc{KnotVector(2, std::move(knots)), Eigen::MatrixX2d(2 * nSpans + 1, 2),
                Eigen::VectorXd::Ones(2 * nSpans + 1)};
    for (int i = 0; i <= 2 * nSpans; ++i) {
        const double phi = startAngle + i * half;
        // Odd points are where the tangents of their neighbours meet.
        const double radius = i % 2 == 0 ? 1 : 1 / std::cos(half);
        arc.points.row(i) << radius * std::cos(phi), radius * std::sin(phi);
        arc.weights[i] = i % 2 == 0 ? 1 : std::cos(half);
    }
    // A full circle closes to the last bit.
    if (std::abs(angle - 2 * pi) <= 2 * pi * 1e-12) {
        arc.points.row(2 * nSpans) = arc.points.row(0);
    }
    return arc;
}

} // namespace

NurbsCurve line(const Point& start, const Point& end) {
    checkPositive((end - start).norm(), "length of the line");
    Points points(2, 3);
    points << start.transpose(), end.transpose();
    return NurbsCurve(linear(), points);
}

NurbsCurve arc(const Point& centre, double radius, double startAngle, double endAngle) {
    checkPositive(radius, "radius of the arc");
    const UnitArc unit = unitArc(startAngle, endAngle);
    Points points = centre.transpose().replicate(unit.points.rows(), 1);
    points.leftCols(2) += radius * unit.points;
    return NurbsCurve(unit.knots, points, unit.weights);
}

NurbsSurface rectangle(const Point& origin, double sizeX, double sizeY) {
    checkPositive(sizeX, "size of the rectangle along x");
    checkPositive(sizeY, "size of the rectangle along y");
    return plate(origin, sizeX * Point::UnitX(), sizeY * Point::UnitY());
}

NurbsSurface plate(const Point& origin, const Point& edgeU, const Point& edgeV) {
    checkPositive(edgeU.norm(), "length of the plate's first edge");
    checkPositive(edgeV.norm(), "length of the plate's second edge");
    const double sine = edgeU.normalized().cross(edgeV.normalized()).norm();
    if (sine < 1e-9) {
        throw InputError(fmt::format("the plate's edges are parallel (the sine of their angle is "
                                     "{:.2g}): it has no area",
                                     sine));
    }
    Points points(4, 3);
    points << origin.transpose(), (origin + edgeU).transpose(), (origin + edgeV).transpose(),
        (origin + edgeU + edgeV).transpose();
    return NurbsSurface(linear(), linear(), points);
}

NurbsSurface ringSector(const Point& centre, double innerRadius, double outerRadius,
                        double startAngle, double endAngle) {
    checkPositive(innerRadius, "inner radius of the ring");
    checkPositive(outerRadius - innerRadius, "thickness of the ring (outer minus inner radius)");
    const UnitArc unit = unitArc(startAngle, endAngle);
    const Eigen::Index n = unit.points.rows();
    Points points = centre.transpose().replicate(2 * n, 1);
    Eigen::VectorXd weights(2 * n);
    for (Eigen::Index j = 0; j < n; ++j) {
        points.row(2 * j).head(2) += innerRadius * unit.points.row(j);
        points.row(2 * j + 1).head(2) += outerRadius * unit.points.row(j);
        weights.segment(2 * j, 2).setConstant(unit.weights[j]);
    }
    return NurbsSurface(linear(), unit.knots, points, weights);
}

NurbsSurface cylinderPatch(const Point& base, double radius, double height, double startAngle,
                           double endAngle) {
    checkPositive(radius, "radius of the cylinder");
    checkPositive(height, "height of the cylinder");
    const UnitArc unit = unitArc(startAngle, endAngle);
    const Eigen::Index n = unit.points.rows();
    Points points = base.transpose().replicate(2 * n, 1);
    points.topRows(n).leftCols(2) += radius * unit.points;
    points.bottomRows(n).leftCols(2) += radius * unit.points;
    points.bottomRows(n).col(2).array() += height;
    Eigen::VectorXd weights(2 * n);
    weights << unit.weights, unit.weights;
    return NurbsSurface(unit.knots, linear(), points, weights);
}

NurbsSurface sphere(const Point& centre, double radius) {
    checkPositive(radius, "radius of the sphere");
    const UnitArc around = unitArc(0, 2 * pi), meridian = unitArc(-pi / 2, pi / 2);
    const Eigen::Index nU = around.points.rows(), nV = meridian.points.rows();
    Points points = centre.transpose().replicate(nU * nV, 1);
    Eigen::VectorXd weights(nU * nV);
    for (Eigen::Index j = 0; j < nV; ++j) {
        // Poles lie on the axis to the last bit.
        const bool isPole = j == 0 || j == nV - 1;
        const double distance = isPole ? 0 : radius * meridian.points(j, 0);
        for (Eigen::Index i = 0; i < nU; ++i) {
            const Eigen::Index k = i + nU * j;
            points(k, 0) += distance * around.points(i, 0);
            points(k, 1) += distance * around.points(i, 1);
            points(k, 2) += radius * meridian.points(j, 1);
            weights[k] = around.weights[i] * meridian.weights[j];
        }
    }
    return NurbsSurface(around.knots, meridian.knots, points, weights);
}

} // namespace tokay::geometry
