#include "mapper/patchIntersection.hpp"

#include "geometry/elementQuadrature.hpp"
#include "mapper/parameterPolygon.hpp"
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <unordered_map>

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

class Intersection {
  public:
    Intersection(const SurfaceMesh& mesh, const SurfaceInterface& splines, double reach, int degree,
                 const IntersectionVisitor& visitor)
        : mesh_(mesh), splines_(splines), reach_(reach), degree_(degree), visitor_(visitor),
          corners_(splines.nPieces()), tree_(boxes(splines)) {}

    void run() {
        for (int triangle = 0; triangle < mesh_.nTriangles(); ++triangle) {
            const std::vector<int> pieces = tree_.overlapping(reachOf(triangle));
            hasRivals_ = pieces.size() > 1;
            double share = 0;
            for (const int piece : pieces)
                share += overPatch(triangle, piece);
            visitor_.endTriangle(triangle, std::min(share, 1.0));
        }
    }

  private:
    static std::vector<geometry::Box> boxes(const SurfaceInterface& splines) {
        std::vector<geometry::Box> boxes;
        for (int i = 0; i < splines.nPieces(); ++i)
            boxes.push_back(splines.box(i));
        return boxes;
    }

    geometry::Box reachOf(int triangle) const {
        geometry::Box box = geometry::Box::empty();
        for (int i = 0; i < 3; ++i)
            box.include(mesh_.triangle(triangle).corner(i));
        return {box.lower - Point::Constant(reach_), box.upper + Point::Constant(reach_)};
    }

    /// @return share of the triangle that the patch covers
    double overPatch(int triangle, int piece) {
        const geometry::NurbsSurface& surface = splines_.piece(piece).patch.basis();
        std::array<ProjectedCorner, 3> corners;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            corners[i] = corner(triangle, i, piece);
            least = std::min(least, corners[i].gap);
            if (!corners[i].converged)
                return 0;
        }
        if (least > reach_)
            return 0;
        const std::array<bool, 2> isClosed = splines_.isClosed(piece);
        const Polygon polygon = parameterPolygon(surface, isClosed, corners);
        const double area = signedArea(polygon);
        if (!(area > 0))
            return 0;
        return overAllTurns(triangle, piece, polygon, isClosed) / area;
    }

    const ProjectedCorner& corner(int triangle, int i, int piece) {
        const int number = mesh_.cornerNumbers(triangle)[i];
        auto& known = corners_[piece];
        auto found = known.find(number);
        if (found == known.end())
            found = known
                        .emplace(number, projectedCorner(splines_.piece(piece).patch.basis(),
                                                         splines_.projector(piece),
                                                         splines_.isClosed(piece),
                                                         mesh_.triangle(triangle).corner(i)))
                        .first;
        return found->second;
    }

    /// A polygon over a seam lies at both ends of the parameter range.
    double overAllTurns(int triangle, int piece, const Polygon& polygon,
                        std::array<bool, 2> isClosed) {
        const geometry::NurbsSurface& surface = splines_.piece(piece).patch.basis();
        const Eigen::Vector2d period(surface.u().last() - surface.u().first(),
                                     surface.v().last() - surface.v().first());
        double area = 0;
        for (int j = isClosed[1] ? -1 : 0; j <= (isClosed[1] ? 1 : 0); ++j)
            for (int i = isClosed[0] ? -1 : 0; i <= (isClosed[0] ? 1 : 0); ++i) {
                Polygon turned = polygon;
                for (Eigen::Vector2d& x : turned)
                    x += Eigen::Vector2d(i * period[0], j * period[1]);
                area += overElements(triangle, piece, turned);
            }
        return area;
    }

    double overElements(int triangle, int piece, const Polygon& polygon) {
        const TrimmedPatch& patch = splines_.piece(piece).patch;
        Eigen::Vector2d lower = polygon[0], upper = polygon[0];
        for (const Eigen::Vector2d& x : polygon) {
            lower = lower.cwiseMin(x);
            upper = upper.cwiseMax(x);
        }
        const Span u = spansBetween(patch.basis().u(), lower[0], upper[0]);
        const Span v = spansBetween(patch.basis().v(), lower[1], upper[1]);
        double area = 0;
        for (int j = v.begin; j < v.end; ++j)
            for (int i = u.begin; i < u.end; ++i)
                area += overElement(triangle, piece, patch.elementNumber(i, j), polygon);
        return area;
    }

    double overElement(int triangle, int piece, int element, const Polygon& polygon) {
        const TrimmedPatch& patch = splines_.piece(piece).patch;
        if (patch.state(element) == ElementState::empty)
            return 0;
        Polygon cell = clippedByRectangle(polygon, patch.elementBox(element).lower,
                                          patch.elementBox(element).upper);
        if (cell.size() < 3 || (hasRivals_ && !isClosest(triangle, piece, cell)))
            return 0;
        parts_.clear();
        if (patch.state(element) == ElementState::cut)
            parts_ = patch.clipped(cell);
        else
            parts_.push_back(std::move(cell));
        double area = 0;
        for (const geometry::ParameterPoint& at : geometry::cellQuadrature(parts_, degree_)) {
            area += at.weight;
            visit(triangle, piece, element, at);
        }
        return area;
    }

    /// Of patches within reach, as the sides of a thin body, the nearest counts.
    bool isClosest(int triangle, int piece, const Polygon& cell) const {
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& x : cell)
            middle += x / static_cast<double>(cell.size());
        const Triangle& plane = mesh_.triangle(triangle);
        const Point here = splines_.piece(piece).patch.basis().point(middle[0], middle[1]);
        const Point foot = plane.at(plane.barycentric(here));
        const double least = splines_.closest(foot).onSurface.distance;
        return (here - foot).norm() <= 2 * least + 1e-6 * splines_.size();
    }

    void visit(int triangle, int piece, int element, const geometry::ParameterPoint& at) {
        const SurfacePiece& onPiece = splines_.piece(piece);
        geometry::SurfaceBasis basis = onPiece.patch.basis().basis(at.xi, at.eta, 1);
        Eigen::Matrix3d d = Eigen::Matrix3d::Zero();
        for (std::size_t i = 0; i < basis.controlPoints.size(); ++i) {
            d += basis.N.col(i) * onPiece.patch.basis().controlPoints().row(basis.controlPoints[i]);
            basis.controlPoints[i] = onPiece.controlPoints[basis.controlPoints[i]];
        }
        IntersectionPoint point;
        point.position = d.row(0);
        point.weight = at.weight * Point(d.row(1)).cross(Point(d.row(2))).norm();
        point.triangle = triangle;
        point.inTriangle = mesh_.triangle(triangle).barycentric(point.position);
        point.gap = (mesh_.triangle(triangle).at(point.inTriangle) - point.position).norm();
        point.element = splines_.elementNumber(piece, element);
        point.onPatch = {std::move(basis.controlPoints), basis.N.row(0)};
        visitor_.point(point);
    }

    const SurfaceMesh& mesh_;
    const SurfaceInterface& splines_;
    double reach_;
    int degree_;
    const IntersectionVisitor& visitor_;
    /// By patch and by the mesh's corner number.
    std::vector<std::unordered_map<int, ProjectedCorner>> corners_;
    geometry::BoxTree tree_;
    bool hasRivals_ = false;
    std::vector<Polygon> parts_;
};

} // namespace

void intersect(const SurfaceMesh& mesh, const SurfaceInterface& splines, double reach, int degree,
               const IntersectionVisitor& visitor) {
    Intersection(mesh, splines, reach, degree, visitor).run();
}

} // namespace tokay::mapper
