// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/patchIntersection.hpp"

#include "geometry/spline/SurfaceEvaluator.hpp"
#include "geometry/trimming/elementQuadrature.hpp"
#include "mapper/intersection/ProjectedCorners.hpp"
#include "mapper/intersection/polePartition.hpp"

#include <algorithm>
#include <limits>

namespace tokay::mapper {

using geometry::clippedByRectangle;
using geometry::ElementState;
using geometry::KnotVector;
using geometry::Polygon;
using geometry::signedArea;
using geometry::Triangle;
using geometry::TrimmedPatch;

namespace {

struct Span {
    int begin, end;
};

/// Breakpoint intervals that the values from lower to upper touch.
Span spansBetween(const KnotVector& knots, double lower, double upper) {
    const std::vector<double>& breakpoints = knots.breakpoints();
    const auto begin = std::upper_bound(breakpoints.begin(), breakpoints.end(), lower);
    const auto end = std::lower_bound(breakpoints.begin(), breakpoints.end(), upper);
    const int last = knots.nSpans();
    return {std::clamp(static_cast<int>(begin - breakpoints.begin()) - 1, 0, last),
            std::clamp(static_cast<int>(end - breakpoints.begin()), 0, last)};
}

/// False for the image of a triangle that stands upright on the patch: its area is rounding,
/// and what the loops leave of it lies anywhere.
/// @param box  of the parameters, which counts as square
bool coversArea(const Polygon& polygon, const geometry::ParameterBox& box) {
    constexpr double rounding = 1e-12; // of a square on the longest side
    const Eigen::Array2d size = box.size();
    double longest = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Array2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
        longest = std::max(longest, (side / size).matrix().squaredNorm());
    }
    return signedArea(polygon) > rounding * longest * size.prod();
}

struct NumberedTriangle {
    int number;
    Triangle plane;
};

class Intersection {
  public:
    Intersection(const SurfaceMesh& mesh, const SurfaceInterface& splines, double reach, int degree,
                 const IntersectionVisitor& visitor)
        : mesh_(mesh), splines_(splines), reach_(reach), degree_(degree), visitor_(visitor),
          corners_(mesh, splines), tree_(boxes(splines)) {
        for (int i = 0; i < splines.nPieces(); ++i) {
            evaluators_.emplace_back(splines.piece(i).patch.basis());
        }
    }

    void run() {
        for (int number = 0; number < mesh_.nTriangles(); ++number) {
            const NumberedTriangle triangle = {number, mesh_.triangle(number)};
            const std::vector<int> pieces = tree_.overlapping(reachOf(triangle.plane));
            hasRivals_ = pieces.size() > 1;
            double share = 0;
            for (const int piece : pieces) {
                share += overPatch(triangle, piece);
            }
            visitor_.endTriangle(number, std::min(share, 1.0));
        }
    }

  private:
    static std::vector<geometry::Box> boxes(const SurfaceInterface& splines) {
        std::vector<geometry::Box> boxes;
        for (int i = 0; i < splines.nPieces(); ++i) {
            boxes.push_back(splines.box(i));
        }
        return boxes;
    }

    geometry::Box reachOf(const Triangle& triangle) const {
        geometry::Box box = geometry::Box::empty();
        for (int i = 0; i < 3; ++i) {
            box.include(triangle.corner(i));
        }
        return {box.lower - Point::Constant(reach_), box.upper + Point::Constant(reach_)};
    }

    /// @return share of the triangle that the patch covers
    double overPatch(const NumberedTriangle& triangle, int piece) {
        std::array<ProjectedCorner, 3> corners;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            corners[i] = corners_.at(triangle.number, i, piece);
            least = std::min(least, corners[i].gap);
            if (!corners[i].converged) {
                return 0;
            }
        }
        if (least > reach_) {
            return 0;
        }
        double covered = 0, whole = 0;
        for (const auto& part : partsAroundPole(splines_, piece, triangle.plane, corners)) {
            const TrimmedPatch& patch = splines_.piece(piece).patch;
            const Polygon polygon = parameterPolygon(patch.basis(), splines_.isClosed(piece), part);
            if (coversArea(polygon, patch.box())) {
                whole += signedArea(polygon);
                covered += overAllTurns(triangle, piece, polygon);
            }
        }
        return whole > 0 ? covered / whole : 0;
    }

    /// A polygon over a seam lies at both ends of the parameter range.
    double overAllTurns(const NumberedTriangle& triangle, int piece, const Polygon& polygon) {
        const std::array<bool, 2> isClosed = splines_.isClosed(piece);
        if (!isClosed[0] && !isClosed[1]) {
            return overElements(triangle, piece, polygon);
        }
        const Eigen::Vector2d period = splines_.piece(piece).patch.box().size();
        double area = 0;
        for (int j = isClosed[1] ? -1 : 0; j <= (isClosed[1] ? 1 : 0); ++j) {
            for (int i = isClosed[0] ? -1 : 0; i <= (isClosed[0] ? 1 : 0); ++i) {
                Polygon turned = polygon;
                for (Eigen::Vector2d& x : turned) {
                    x += Eigen::Vector2d(i * period[0], j * period[1]);
                }
                area += overElements(triangle, piece, turned);
            }
        }
        return area;
    }

    double overElements(const NumberedTriangle& triangle, int piece, const Polygon& polygon) {
        const TrimmedPatch& patch = splines_.piece(piece).patch;
        Eigen::Vector2d lower = polygon[0], upper = polygon[0];
        for (const Eigen::Vector2d& x : polygon) {
            lower = lower.cwiseMin(x);
            upper = upper.cwiseMax(x);
        }
        const Span u = spansBetween(patch.basis().u(), lower[0], upper[0]);
        const Span v = spansBetween(patch.basis().v(), lower[1], upper[1]);
        double area = 0;
        for (int j = v.begin; j < v.end; ++j) {
            for (int i = u.begin; i < u.end; ++i) {
                const int element = patch.elementNumber(i, j);
                const geometry::ParameterBox box = patch.elementBox(element);
                const bool isInside = (lower.array() >= box.lower.array()).all() &&
                                      (upper.array() <= box.upper.array()).all();
                area += overElement(triangle, piece, element,
                                    isInside ? polygon
                                             : clippedByRectangle(polygon, box.lower, box.upper));
            }
        }
        return area;
    }

    /// @param cell  the part of the triangle's image in the element
    double overElement(const NumberedTriangle& triangle, int piece, int element,
                       const Polygon& cell) {
        const TrimmedPatch& patch = splines_.piece(piece).patch;
        if (patch.state(element) == ElementState::empty || cell.size() < 3 ||
            (hasRivals_ && !isClosest(triangle, piece, cell))) {
            return 0;
        }
        points_.clear();
        if (patch.state(element) == ElementState::cut) {
            for (const Polygon& part : patch.clipped(cell)) {
                geometry::appendCellQuadrature(part, degree_, points_);
            }
        } else {
            geometry::appendCellQuadrature(cell, degree_, points_);
        }
        evaluators_[piece].enter(patch.elementBox(element).centre());
        double area = 0;
        for (const geometry::ParameterPoint& at : points_) {
            area += at.weight;
            visit(triangle, piece, element, at);
        }
        return area;
    }

    /// Nearest of the patches within reach, such as the two sides of a thin body.
    bool isClosest(const NumberedTriangle& triangle, int piece, const Polygon& cell) const {
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& x : cell) {
            middle += x / static_cast<double>(cell.size());
        }
        const Triangle& plane = triangle.plane;
        const Point here = splines_.piece(piece).patch.basis().point(middle[0], middle[1]);
        const Point foot = plane.at(plane.barycentric(here));
        const double least = splines_.closest(foot).onSurface.distance;
        return (here - foot).norm() <= 2 * least + 1e-6 * splines_.size();
    }

    void visit(const NumberedTriangle& triangle, int piece, int element,
               const geometry::ParameterPoint& at) {
        geometry::SurfaceEvaluator& surface = evaluators_[piece];
        surface.evaluate(at.xi, at.eta);
        const std::vector<int>& numbers = splines_.piece(piece).controlPoints;
        point_.position = surface.point();
        point_.weight = at.weight * surface.jacobian();
        point_.triangle = triangle.number;
        point_.inTriangle = triangle.plane.barycentric(point_.position);
        point_.gap = (triangle.plane.at(point_.inTriangle) - point_.position).norm();
        point_.piece = piece;
        point_.element = splines_.elementNumber(piece, element);
        point_.onPatch.values = surface.controlPoints();
        for (int& number : point_.onPatch.values) {
            number = numbers[number];
        }
        point_.onPatch.weights = surface.N();
        visitor_.point(point_);
    }

    const SurfaceMesh& mesh_;
    const SurfaceInterface& splines_;
    double reach_;
    int degree_;
    const IntersectionVisitor& visitor_;
    ProjectedCorners corners_;
    geometry::BoxTree tree_;
    std::vector<geometry::SurfaceEvaluator> evaluators_;
    bool hasRivals_ = false;
    std::vector<geometry::ParameterPoint> points_;
    IntersectionPoint point_;
};

} // namespace

void intersect(const SurfaceMesh& mesh, const SurfaceInterface& splines, double reach, int degree,
               const IntersectionVisitor& visitor) {
    Intersection(mesh, splines, reach, degree, visitor).run();
}

} // namespace tokay::mapper
