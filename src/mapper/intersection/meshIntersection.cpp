// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/meshIntersection.hpp"

#include "geometry/quadrature/Polygon.hpp"
#include "geometry/quadrature/triangleRule.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace tokay::mapper {

using geometry::Barycentric;
using geometry::clippedByConvex;
using geometry::Polygon;
using geometry::signedArea;
using geometry::Triangle;

namespace {

using Rectangle = Eigen::AlignedBox2d;

Rectangle around(const Polygon& polygon) {
    Rectangle rectangle;
    for (const Eigen::Vector2d& corner : polygon) {
        rectangle.extend(corner);
    }
    return rectangle;
}

/// Plane of a triangle, with coordinates along two axes of unit length.
class Plane {
  public:
    explicit Plane(const Triangle& triangle) : origin_(triangle.corner(0)) {
        axes_.row(0) = (triangle.corner(1) - origin_).normalized();
        axes_.row(1) = triangle.unitNormal().cross(Point(axes_.row(0)));
    }

    Eigen::Vector2d project(const Point& point) const { return axes_ * (point - origin_); }
    Point lift(const Eigen::Vector2d& x) const { return origin_ + axes_.transpose() * x; }

    /// Counter-clockwise, whichever way the triangle faces.
    Polygon project(const Triangle& triangle) const {
        Polygon polygon;
        for (int i = 0; i < 3; ++i) {
            polygon.push_back(project(triangle.corner(i)));
        }
        if (signedArea(polygon) < 0) {
            std::swap(polygon[1], polygon[2]);
        }
        return polygon;
    }

    /// A rectangle of the plane that contains the box's projection.
    Rectangle project(const geometry::Box& box) const {
        const Eigen::Vector2d middle = project(box.centre());
        const Eigen::Vector2d half = 0.5 * (axes_.cwiseAbs() * (box.upper - box.lower));
        return {middle - half, middle + half};
    }

  private:
    Point origin_;
    Eigen::Matrix<double, 2, 3> axes_;
};

geometry::Box boxOf(const Triangle& triangle) {
    geometry::Box box = geometry::Box::empty();
    for (int i = 0; i < 3; ++i) {
        box.include(triangle.corner(i));
    }
    return box;
}

Point foot(const Triangle& triangle, const Point& point) {
    return triangle.at(triangle.barycentric(point));
}

/// Another side of a thin body can lie within reach too: the source that counts
/// is the one that is closest to the piece. None is less than half as far.
bool isClosest(const SurfaceMesh& from, const Triangle& source, const Point& middle,
               double rounding) {
    const double gap = (foot(source, middle) - middle).norm();
    const double limit = 0.5 * (gap - rounding);
    if (limit <= 0) {
        return true;
    }
    const std::vector<int> near =
        from.tree().overlapping({middle - Point::Constant(limit), middle + Point::Constant(limit)});
    return std::none_of(near.begin(), near.end(), [&](int i) {
        const Triangle& other = from.triangle(i);
        return (other.at(other.closest(middle)) - middle).norm() < limit;
    });
}

class Integration {
  public:
    Integration(const SurfaceMesh& from, const SurfaceMesh& to, const GapLimit& limit,
                MortarAssembler& assembler, GapStatistics& gaps)
        : from_(from), to_(to), reach_(limit.relative * from.size()), assembler_(assembler),
          gaps_(gaps),
          rule_(geometry::triangleRule(to.degree() + std::max(from.degree(), to.degree()))) {}

    void overTriangle(int number) {
        const Triangle& destination = to_.triangle(number);
        const Plane plane(destination);
        const Polygon target = plane.project(destination);
        to_.evaluateCorners(number, toValues_, onTo_);
        double covered = 0;
        for (const int i : sourcesAlongNormal(destination, plane, target)) {
            covered += overPiece(number, i, plane,
                                 clippedByConvex(plane.project(from_.triangle(i)), target));
        }
        countUncovered(number, destination.area() - covered);
    }

  private:
    /// Triangles within reach of which the box, seen along the normal, overlaps the target:
    /// no other one has a piece of it.
    std::vector<int> sourcesAlongNormal(const Triangle& destination, const Plane& plane,
                                        const Polygon& target) const {
        geometry::Box within = boxOf(destination);
        within.lower.array() -= reach_;
        within.upper.array() += reach_;
        Rectangle seen = around(target);
        const Eigen::Vector2d rounding = Eigen::Vector2d::Constant(1e-6 * seen.diagonal().norm());
        seen.extend(seen.min() - rounding);
        seen.extend(seen.max() + rounding);
        return from_.tree().meeting([&](const geometry::Box& box) {
            return box.overlaps(within) && plane.project(box).intersects(seen);
        });
    }

    /// @return the piece's area, 0 if its source is not the one that counts
    double overPiece(int toTriangle, int fromTriangle, const Plane& plane, const Polygon& piece) {
        const Triangle &destination = to_.triangle(toTriangle),
                       &source = from_.triangle(fromTriangle);
        const double area = piece.size() < 3 ? 0 : signedArea(piece);
        // A touching neighbour gives a piece of rounding size.
        if (area <= 1e-14 * destination.area()) {
            return 0;
        }
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& corner : piece) {
            middle += corner / static_cast<double>(piece.size());
        }
        if (!isClosest(from_, source, plane.lift(middle), 1e-6 * from_.size())) {
            return 0;
        }
        integrate(toTriangle, fromTriangle, plane, piece);
        return area;
    }

    /// All functions are linear on a piece, so their products follow from those of the
    /// triangles' barycentric coordinates.
    void integrate(int toTriangle, int fromTriangle, const Plane& plane, const Polygon& piece) {
        const Triangle &destination = to_.triangle(toTriangle),
                       &source = from_.triangle(fromTriangle);
        Eigen::Matrix3d mass = Eigen::Matrix3d::Zero(), cross = mass;
        bool isMatched = false, isUnmatched = false;
        for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
            const Polygon part = {piece[0], piece[i], piece[i + 1]};
            const double area = signedArea(part);
            for (std::size_t k = 0; k < rule_.points.size(); ++k) {
                const Barycentric& at = rule_.points[k];
                const Point point = plane.lift(at[0] * part[0] + at[1] * part[1] + at[2] * part[2]);
                const double weight = rule_.weights[k] * area;
                const Barycentric inSource = source.barycentric(point);
                const double gap = (source.at(inSource) - point).norm();
                if (!gaps_.count(point, gap, true, false, weight)) {
                    isUnmatched = true;
                    continue;
                }
                const Barycentric here = destination.barycentric(point);
                mass += weight * here * here.transpose();
                cross += weight * here * inSource.transpose();
                isMatched = true;
            }
        }
        enter(fromTriangle, isMatched, isUnmatched, mass, cross);
    }

    void enter(int fromTriangle, bool isMatched, bool isUnmatched, const Eigen::Matrix3d& mass,
               const Eigen::Matrix3d& cross) {
        if (isMatched) {
            from_.evaluateCorners(fromTriangle, fromValues_, onFrom_);
            assembler_.add(toValues_, fromValues_, onTo_ * mass * onTo_.transpose(),
                           onTo_ * cross * onFrom_.transpose());
        }
        if (isUnmatched) {
            for (const int value : toValues_) {
                assembler_.addUnmatched(value);
            }
        }
    }

    void countUncovered(int toTriangle, double area) {
        if (area <= 1e-9 * to_.triangle(toTriangle).area()) {
            return;
        }
        gaps_.countUncovered(area);
        for (const int value : toValues_) {
            assembler_.addUnmatched(value);
        }
    }

    const SurfaceMesh &from_, &to_;
    double reach_;
    MortarAssembler& assembler_;
    GapStatistics& gaps_;
    const geometry::TriangleRule& rule_;
    std::vector<int> toValues_, fromValues_;
    Eigen::Matrix<double, Eigen::Dynamic, 3> onTo_, onFrom_; ///< functions at corners
};

} // namespace

void integrateIntersection(const SurfaceMesh& from, const SurfaceMesh& to, const GapLimit& gapLimit,
                           MortarAssembler& assembler, GapStatistics& gaps) {
    Integration integration(from, to, gapLimit, assembler, gaps);
    for (int i = 0; i < to.nTriangles(); ++i) {
        integration.overTriangle(i);
        if (i + 1 == to.nTriangles() || to.faceOf(i + 1) != to.faceOf(i)) {
            assembler.endGroup();
        }
    }
}

} // namespace tokay::mapper
