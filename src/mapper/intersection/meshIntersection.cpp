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

/// A triangle of the source that may matter.
struct Candidate {
    int number;
    Triangle triangle;
    Box box;
};

void appendTriangles(const SurfaceMesh& mesh, const std::vector<int>& faces,
                     std::vector<Candidate>& candidates) {
    for (const int face : faces) {
        for (int i = mesh.firstTriangle(face); i < mesh.firstTriangle(face + 1); ++i) {
            const Triangle triangle = mesh.triangle(i);
            candidates.push_back({i, triangle, boxOf(triangle)});
        }
    }
}

/// Part of a destination triangle over which a source triangle lies.
struct Piece {
    const Candidate *destination, *source;
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
    /// @param box  of the pieces
    void gather(const Box& box, const std::vector<Piece>& pieces) {
        faces_.clear();
        double clearance = 0;
        for (const Piece& piece : pieces) {
            clearance = std::max(clearance, piece.clearance);
        }
        if (clearance > 0) {
            faces_ = from_.tree().overlapping(grown(box, clearance));
        }
    }

    bool isClosest(const Piece& piece) const {
        if (piece.clearance <= 0) {
            return true;
        }
        const Box near = grown({piece.middle, piece.middle}, piece.clearance);
        return std::none_of(faces_.begin(), faces_.end(), [&](int face) {
            return from_.tree().box(face).overlaps(near) && isNearer(face, piece);
        });
    }

  private:
    bool isNearer(int face, const Piece& piece) const {
        for (int i = from_.firstTriangle(face); i < from_.firstTriangle(face + 1); ++i) {
            const Triangle rival = from_.triangle(i);
            // Its plane is most often too far already.
            if (std::abs(Height(rival).of(piece.middle)) < piece.clearance &&
                (rival.at(rival.closest(piece.middle)) - piece.middle).norm() < piece.clearance) {
                return true;
            }
        }
        return false;
    }

    const SurfaceMesh& from_;
    std::vector<int> faces_;
};

class Integration {
  public:
    Integration(const SurfaceMesh& from, const SurfaceMesh& to, const GapLimit& limit,
                MortarAssembler& assembler, GapStatistics& gaps)
        : from_(from), to_(to), reach_(limit.relative * from.size()), assembler_(assembler),
          gaps_(gaps), rivals_(from),
          rule_(geometry::triangleRule(to.degree() + std::max(from.degree(), to.degree()))) {}

    void overFace(int face) {
        destinations_.clear();
        appendTriangles(to_, {face}, destinations_);
        gatherCandidates();
        pieces_.clear();
        for (std::size_t i = 0; i < destinations_.size(); ++i) {
            appendPieces(destinations_[i], views_[i]);
        }
        rivals_.gather(box_, pieces_);
        auto piece = pieces_.begin();
        for (const Candidate& destination : destinations_) {
            to_.evaluateCorners(destination.number, onTo_);
            double covered = 0;
            for (; piece != pieces_.end() && piece->destination == &destination; ++piece) {
                if (rivals_.isClosest(*piece)) {
                    integrate(*piece);
                    covered += piece->overlap.share();
                }
            }
            countUncovered(destination.triangle.area(), 1 - covered);
        }
        assembler_.endGroup();
    }

  private:
    /// Within reach of the face, and seen along the normal of one of its triangles.
    void gatherCandidates() {
        box_ = Box::empty();
        views_.clear();
        for (const Candidate& destination : destinations_) {
            box_.include(destination.box);
            views_.emplace_back(destination.triangle);
        }
        const Box within = grown(box_, reach_);
        candidates_.clear();
        appendTriangles(from_, from_.tree().meeting([&](const Box& box) {
            return box.overlaps(within) &&
                   std::any_of(views_.begin(), views_.end(),
                               [&](const View& view) { return view.meets(box); });
        }),
                        candidates_);
    }

    /// Of triangles within reach of which the box, seen along the normal, meets the triangle: no
    /// other one has a piece of it.
    void appendPieces(const Candidate& destination, const View& view) {
        const Box within = grown(destination.box, reach_);
        for (const Candidate& source : candidates_) {
            if (!source.box.overlaps(within) || !view.meets(source.box)) {
                continue;
            }
            const TriangleOverlap overlap(destination.triangle, source.triangle);
            // A touching neighbour gives a piece of rounding size.
            if (overlap.share() > 1e-14) {
                const Height height(source.triangle);
                const Point middle = destination.triangle.at(overlap.middle());
                const double clearance = 0.5 * (std::abs(height.of(middle)) - 1e-6 * from_.size());
                pieces_.push_back({&destination, &source, overlap, height, middle, clearance});
            }
        }
    }

    /// All functions are linear on a piece, so their products follow from those of the
    /// destination's barycentric coordinates; the source's are linear in these.
    void integrate(const Piece& piece) {
        const Triangle& destination = piece.destination->triangle;
        const Gap gap = largestGap(piece);
        if (gap.size > reach_) {
            integrateByPoints(piece);
            return;
        }
        gaps_.count(gap.at, gap.size, true, false, piece.overlap.share() * destination.area());
        const Eigen::Matrix3d mass = destination.area() * piece.overlap.moments();
        enter(piece, true, false, mass);
    }

    struct Gap {
        Point at;
        double size;
    };
    /// At a corner: no point between them is farther from the source's plane.
    static Gap largestGap(const Piece& piece) {
        Gap largest{Point::Zero(), -1};
        for (int i = 0; i < piece.overlap.nCorners(); ++i) {
            const Point corner = piece.destination->triangle.at(piece.overlap.corner(i));
            const double gap = std::abs(piece.height.of(corner));
            if (gap > largest.size) {
                largest = {corner, gap};
            }
        }
        return largest;
    }

    /// Column i: the source's barycentric coordinates at the destination's corner i.
    static Eigen::Matrix3d seenFromSource(const Piece& piece) {
        Eigen::Matrix3d coordinates;
        for (int i = 0; i < 3; ++i) {
            coordinates.col(i) =
                piece.source->triangle.barycentric(piece.destination->triangle.corner(i));
        }
        return coordinates;
    }

    /// A piece of which a part is out of reach, which then counts as unmatched.
    void integrateByPoints(const Piece& piece) {
        const Triangle& destination = piece.destination->triangle;
        Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
        bool isMatched = false, isUnmatched = false;
        for (int i = 1; i + 1 < piece.overlap.nCorners(); ++i) {
            Eigen::Matrix3d corners;
            corners << piece.overlap.corner(0), piece.overlap.corner(i),
                piece.overlap.corner(i + 1);
            const double area = piece.overlap.share(i) * destination.area();
            for (std::size_t k = 0; k < rule_.points.size(); ++k) {
                const Barycentric here = corners * rule_.points[k];
                const Point point = destination.at(here);
                const double weight = rule_.weights[k] * area;
                if (!gaps_.count(point, std::abs(piece.height.of(point)), true, false, weight)) {
                    isUnmatched = true;
                    continue;
                }
                mass += weight * here * here.transpose();
                isMatched = true;
            }
        }
        enter(piece, isMatched, isUnmatched, mass);
    }

    void enter(const Piece& piece, bool isMatched, bool isUnmatched, const Eigen::Matrix3d& mass) {
        if (isMatched) {
            from_.evaluateCorners(piece.source->number, onFrom_);
            assembler_.add(onTo_, onFrom_, mass, mass * seenFromSource(piece).transpose());
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
    const geometry::TriangleRule& rule_; ///< where a piece is out of reach in part
    /// Of the face: its triangles, what each sees, their box, what of the source may lie over
    /// it, and what does.
    std::vector<Candidate> destinations_;
    std::vector<View> views_;
    Box box_ = Box::empty();
    std::vector<Candidate> candidates_;
    std::vector<Piece> pieces_;
    CornerFunctions onTo_, onFrom_;
};

} // namespace

void integrateIntersection(const SurfaceMesh& from, const SurfaceMesh& to, const GapLimit& gapLimit,
                           MortarAssembler& assembler, GapStatistics& gaps) {
    Integration integration(from, to, gapLimit, assembler, gaps);
    for (int face = 0; face < to.nFaces(); ++face) {
        integration.overFace(face);
    }
}

} // namespace tokay::mapper
