// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/meshIntersection.hpp"

#include "geometry/quadrature/triangleRule.hpp"
#include "mapper/intersection/TriangleOverlap.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::mapper {

using geometry::Barycentric;
using geometry::Box;
using geometry::Triangle;

namespace {

/// What is seen along the normal of a triangle within its sides, and a little beyond them.
class View {
  public:
    explicit View(const Triangle& triangle) : origin_(triangle.corner(0)) {
        gradients_.bottomRows<2>() = triangle.gradients();
        gradients_.row(0) = -triangle.gradients().colwise().sum();
        sizes_ = gradients_.cwiseAbs();
    }

    /// False only if nothing in the box is seen.
    bool meets(const Box& box) const {
        constexpr double rounding = 1e-6;
        const Barycentric middle =
            Barycentric::Unit(0) + gradients_ * (0.5 * (box.lower + box.upper) - origin_);
        return ((middle + 0.5 * (sizes_ * (box.upper - box.lower))).array() >= -rounding).all();
    }

  private:
    Point origin_;
    Eigen::Matrix3d gradients_; ///< row i: that of coordinate i
    Eigen::Matrix3d sizes_;
};

Box boxOf(const Triangle& triangle) {
    Box box = Box::empty();
    for (int i = 0; i < 3; ++i) {
        box.include(triangle.corner(i));
    }
    return box;
}

Box grown(const Box& box, double by) {
    return {box.lower - Point::Constant(by), box.upper + Point::Constant(by)};
}

/// Signed distance of points from the plane of a triangle.
class Height {
  public:
    explicit Height(const Triangle& triangle)
        : origin_(triangle.corner(0)), normal_(triangle.unitNormal()) {}
    double of(const Point& point) const { return normal_.dot(point - origin_); }

  private:
    Point origin_, normal_;
};

/// Part of a destination triangle over which a source triangle lies.
struct Piece {
    int source;
    TriangleOverlap overlap;
    Height height; ///< over the source
    Point middle;
    /// No other triangle of the source is nearer to the middle.
    double clearance;
};

/// Another side of a thin body can lie within reach too: the source that counts
/// is the one that is closest to the piece. None is less than half as far.
class Rivals {
  public:
    explicit Rivals(const SurfaceMesh& from) : from_(from) {}

    /// Gathers those that may be near to any of the pieces.
    void gather(const Triangle& destination, const std::vector<Piece>& pieces) {
        rivals_.clear();
        double clearance = 0;
        for (const Piece& piece : pieces) {
            clearance = std::max(clearance, piece.clearance);
        }
        if (clearance > 0) {
            for (const int i : from_.tree().overlapping(grown(boxOf(destination), clearance))) {
                rivals_.push_back({i, boxOf(from_.triangle(i))});
            }
        }
    }

    bool isClosest(const Piece& piece) const {
        if (piece.clearance <= 0) {
            return true;
        }
        const Box near = grown({piece.middle, piece.middle}, piece.clearance);
        return std::none_of(rivals_.begin(), rivals_.end(), [&](const Rival& rival) {
            return rival.box.overlaps(near) && isNearer(from_.triangle(rival.triangle), piece);
        });
    }

  private:
    static bool isNearer(const Triangle& rival, const Piece& piece) {
        return (rival.at(rival.closest(piece.middle)) - piece.middle).norm() < piece.clearance;
    }

    struct Rival {
        int triangle;
        Box box;
    };
    const SurfaceMesh& from_;
    std::vector<Rival> rivals_;
};

class Integration {
  public:
    Integration(const SurfaceMesh& from, const SurfaceMesh& to, const GapLimit& limit,
                MortarAssembler& assembler, GapStatistics& gaps)
        : from_(from), to_(to), reach_(limit.relative * from.size()), assembler_(assembler),
          gaps_(gaps), rivals_(from),
          rule_(geometry::triangleRule(to.degree() + std::max(from.degree(), to.degree()))) {}

    void overTriangle(int number) {
        const Triangle& destination = to_.triangle(number);
        to_.evaluateCorners(number, onTo_);
        gatherPieces(destination);
        rivals_.gather(destination, pieces_);
        double covered = 0;
        for (const Piece& piece : pieces_) {
            if (rivals_.isClosest(piece)) {
                integrate(destination, piece);
                covered += piece.overlap.share();
            }
        }
        countUncovered(destination.area(), 1 - covered);
    }

  private:
    /// Of triangles within reach of which the box, seen along the normal, meets the triangle: no
    /// other one has a piece of it.
    void gatherPieces(const Triangle& destination) {
        const Box within = grown(boxOf(destination), reach_);
        const View view(destination);
        const std::vector<int> sources = from_.tree().meeting(
            [&](const Box& box) { return box.overlaps(within) && view.meets(box); });
        pieces_.clear();
        for (const int source : sources) {
            const Triangle& triangle = from_.triangle(source);
            const TriangleOverlap overlap(destination, triangle);
            // A touching neighbour gives a piece of rounding size.
            if (overlap.share() > 1e-14) {
                const Height height(triangle);
                const Point middle = destination.at(overlap.middle());
                const double clearance = 0.5 * (std::abs(height.of(middle)) - 1e-6 * from_.size());
                pieces_.push_back({source, overlap, height, middle, clearance});
            }
        }
    }

    /// All functions are linear on a piece, so their products follow from those of the
    /// triangles' barycentric coordinates.
    void integrate(const Triangle& destination, const Piece& piece) {
        const Triangle& source = from_.triangle(piece.source);
        const double whole = destination.area();
        Eigen::Matrix3d mass = Eigen::Matrix3d::Zero(), cross = mass;
        bool isMatched = false, isUnmatched = false;
        for (int i = 1; i + 1 < piece.overlap.nCorners(); ++i) {
            Eigen::Matrix3d corners;
            corners << piece.overlap.corner(0), piece.overlap.corner(i),
                piece.overlap.corner(i + 1);
            const double area = piece.overlap.share(i) * whole;
            for (std::size_t k = 0; k < rule_.points.size(); ++k) {
                const Barycentric here = corners * rule_.points[k];
                const Point point = destination.at(here);
                const double weight = rule_.weights[k] * area;
                if (!gaps_.count(point, std::abs(piece.height.of(point)), true, false, weight)) {
                    isUnmatched = true;
                    continue;
                }
                const Barycentric weighted = weight * here;
                mass += weighted * here.transpose();
                cross += weighted * source.barycentric(point).transpose();
                isMatched = true;
            }
        }
        enter(piece.source, isMatched, isUnmatched, mass, cross);
    }

    void enter(int fromTriangle, bool isMatched, bool isUnmatched, const Eigen::Matrix3d& mass,
               const Eigen::Matrix3d& cross) {
        if (isMatched) {
            from_.evaluateCorners(fromTriangle, onFrom_);
            assembler_.add(onTo_, onFrom_, mass, cross);
        }
        if (isUnmatched) {
            assembler_.addUnmatched(onTo_.values);
        }
    }

    void countUncovered(double area, double share) {
        if (share <= 1e-9) {
            return;
        }
        gaps_.countUncovered(share * area);
        assembler_.addUnmatched(onTo_.values);
    }

    const SurfaceMesh &from_, &to_;
    double reach_;
    MortarAssembler& assembler_;
    GapStatistics& gaps_;
    Rivals rivals_;
    const geometry::TriangleRule& rule_;
    std::vector<Piece> pieces_;
    CornerFunctions onTo_, onFrom_;
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
