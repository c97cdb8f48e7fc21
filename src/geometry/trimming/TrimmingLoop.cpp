// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/TrimmingLoop.hpp"

#include "common/errors.hpp"
#include "geometry/bezier/bezierContact.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/spline/curveParts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

std::string text(const Parameters& point) {
    return fmt::format("({:.9g}, {:.9g})", point[0], point[1]);
}

ParameterBox boxAround(const std::vector<NurbsCurve>& curves) {
    ParameterBox box{startOf(curves[0]), startOf(curves[0])};
    for (const NurbsCurve& curve : curves) {
        const auto points = curve.controlPoints().leftCols<2>();
        box.lower = box.lower.cwiseMin(points.colwise().minCoeff().transpose());
        box.upper = box.upper.cwiseMax(points.colwise().maxCoeff().transpose());
    }
    return box;
}

/// Moves the ends of neighbours to one point.
std::vector<NurbsCurve> closed(std::vector<NurbsCurve> curves, const Parameters& size) {
    const std::size_t n = curves.size();
    std::vector<Parameters> joints(n); // before curve i
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        const Parameters end = endOf(curves[before]), start = startOf(curves[i]);
        const Parameters gap = (end - start).cwiseAbs();
        if ((gap.array() > TrimmingLoop::closingTolerance * size.array()).any()) {
            throw InputError(
                fmt::format("a trimming loop is open: curve {} ends at {}, but curve {} "
                            "starts at {}; let each curve start where the one before it "
                            "ends",
                            before, text(end), i, text(start)));
        }
        joints[i] = gap.isZero(0) ? start : Parameters(0.5 * (start + end));
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (startOf(curves[i]) != joints[i] || endOf(curves[i]) != joints[(i + 1) % n]) {
            curves[i] = withEnds(curves[i], joints[i], joints[(i + 1) % n]);
        }
    }
    return curves;
}

void appendMonotone(const PlaneBezier& piece, std::vector<PlaneBezier>& pieces) {
    std::vector<double> turns = piece.extrema(0);
    const std::vector<double> more = piece.extrema(1);
    turns.insert(turns.end(), more.begin(), more.end());
    std::sort(turns.begin(), turns.end());
    PlaneBezier remainder = piece;
    double done = 0;
    for (const double t : turns) {
        if (t <= done + 1e-14 || t >= 1 - 1e-14) {
            continue;
        }
        const auto [first, second] = remainder.split((t - done) / (1 - done));
        pieces.push_back(first);
        remainder = second;
        done = t;
    }
    pieces.push_back(remainder);
}

std::vector<PlaneBezier> monotonePieces(const std::vector<NurbsCurve>& curves) {
    std::vector<PlaneBezier> pieces;
    for (const NurbsCurve& curve : curves) {
        const std::size_t first = pieces.size();
        for (const PlaneBezier& piece : PlaneBezier::piecesOf(curve)) {
            appendMonotone(piece, pieces);
        }
        // Bezier pieces come from quotients, whose ends may be a rounding off.
        pieces[first] = pieces[first].withEnds(startOf(curve), pieces[first].end());
        pieces.back() = pieces.back().withEnds(pieces.back().start(), endOf(curve));
    }
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        if (pieces[i].start() != pieces[i - 1].end()) {
            pieces[i] = pieces[i].withEnds(pieces[i - 1].end(), pieces[i].end());
        }
    }
    return pieces;
}

/// Pieces without those that are too short to be told from a touch of their
/// neighbours (the hook of a control point that is off by rounding).
std::vector<PlaneBezier> withoutShort(const std::vector<PlaneBezier>& pieces,
                                      const Parameters& size) {
    constexpr double shortest = 10 * TrimmingLoop::touchingTolerance;
    std::vector<PlaneBezier> kept;
    Parameters joint = pieces.front().start();
    for (const PlaneBezier& piece : pieces) {
        if (((piece.end() - joint).cwiseAbs().array() > shortest * size.array()).any()) {
            kept.push_back(piece.start() == joint ? piece : piece.withEnds(joint, piece.end()));
            joint = piece.end();
        }
    }
    if (joint != pieces.back().end()) {
        kept.back() = kept.back().withEnds(kept.back().start(), pieces.back().end());
    }
    return kept;
}

/// Pieces as seen in a box of unit size.
std::vector<PlaneBezier> scaled(const std::vector<PlaneBezier>& pieces, const ParameterBox& box) {
    std::vector<PlaneBezier> result;
    for (const PlaneBezier& piece : pieces) {
        result.push_back(piece.scaled(box.lower, box.size().cwiseInverse()));
    }
    return result;
}

/// Halves, so that no two pieces of a loop share both ends.
std::vector<PlaneBezier> halved(const std::vector<PlaneBezier>& pieces) {
    std::vector<PlaneBezier> result;
    for (const PlaneBezier& piece : pieces) {
        for (const PlaneBezier& half : piece.split(0.5)) {
            result.push_back(half);
        }
    }
    return result;
}

std::optional<Parameters> selfContact(const std::vector<PlaneBezier>& pieces) {
    const std::size_t n = pieces.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double tolerance = TrimmingLoop::touchingTolerance;
        if (const auto found = contactBesideJoint(pieces[i], pieces[(i + 1) % n], tolerance)) {
            return found;
        }
        for (std::size_t j = i + 2; j < n; ++j) {
            if ((j + 1) % n != i) {
                if (const auto found = contact(pieces[i], pieces[j], tolerance)) {
                    return found;
                }
            }
        }
    }
    return std::nullopt;
}

/// Area to the left of a piece, as seen from the origin.
double sectorArea(const PlaneBezier& piece, const Parameters& origin) {
    // Exact for polynomials of degree 12, spectral for rational curves.
    const QuadratureRule& rule = gaussLegendre(24);
    double twice = 0;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
        const auto [point, derivative] = piece.tangent(rule.points[k]);
        const Parameters arm = point - origin;
        twice += rule.weights[k] * (arm[0] * derivative[1] - arm[1] * derivative[0]);
    }
    return 0.5 * twice;
}

} // namespace

TrimmingLoop::TrimmingLoop(LoopKind kind, std::vector<NurbsCurve> curves) : kind_(kind) {
    if (curves.empty()) {
        throw InputError("a trimming loop has no curve: give it at least one");
    }
    box_ = boxAround(curves);
    if (!(box_.size().array() > 0).all()) {
        throw InputError(fmt::format("a trimming loop has no area: it lies between {} and {}",
                                     text(box_.lower), text(box_.upper)));
    }
    curves_ = closed(std::move(curves), box_.size());
    pieces_ = withoutShort(monotonePieces(curves_), box_.size());
    if (const auto place = selfContact(halved(scaled(pieces_, box_)))) {
        const Parameters at = box_.lower + place->cwiseProduct(box_.size());
        throw InputError(fmt::format("a trimming loop crosses or touches itself at {}; correct "
                                     "its curves, or make two loops of it",
                                     text(at)));
    }
    const bool isOuter = kind == LoopKind::outer;
    if ((signedArea() > 0) != isOuter) {
        throw InputError(fmt::format("an {} trimming loop (between {} and {}) runs {}, but must "
                                     "run {}; reverse its curves and their order",
                                     isOuter ? "outer" : "inner", text(box_.lower),
                                     text(box_.upper), isOuter ? "clockwise" : "counter-clockwise",
                                     isOuter ? "counter-clockwise" : "clockwise"));
    }
}

double TrimmingLoop::signedArea() const {
    double area = 0;
    for (const PlaneBezier& piece : pieces_) {
        area += sectorArea(piece, box_.centre());
    }
    return area;
}

int TrimmingLoop::winding(const Parameters& point) const {
    int winding = 0;
    for (const PlaneBezier& piece : pieces_) {
        const double from = piece.start()[1], to = piece.end()[1];
        // Half-open, so that a joint counts once.
        if ((from <= point[1]) == (to <= point[1])) {
            continue;
        }
        const double low = std::min(piece.start()[0], piece.end()[0]);
        const double high = std::max(piece.start()[0], piece.end()[0]);
        const bool isLeft =
            high < point[0] ||
            (low < point[0] && piece.point(piece.parameterAt(1, point[1]))[0] < point[0]);
        if (isLeft) {
            winding += to < from ? 1 : -1;
        }
    }
    return winding;
}

Polygon TrimmingLoop::tessellated(const Parameters& chordTolerance) const {
    Polygon polygon;
    for (const PlaneBezier& piece : pieces_) {
        piece.appendChords(chordTolerance, polygon);
    }
    return polygon;
}

bool TrimmingLoop::meets(const TrimmingLoop& other) const {
    if (!box_.overlaps(other.box_)) {
        return false;
    }
    const bool isLarger = box_.area() >= other.box_.area();
    const ParameterBox& box = isLarger ? box_ : other.box_;
    const std::vector<PlaneBezier> mine = scaled(pieces_, box), theirs = scaled(other.pieces_, box);
    for (const PlaneBezier& a : mine) {
        for (const PlaneBezier& b : theirs) {
            if (contact(a, b, touchingTolerance)) {
                return true;
            }
        }
    }
    return false;
}

TrimmingLoop TrimmingLoop::around(const ParameterBox& box) {
    const Parameters corners[4] = {
        box.lower, {box.upper[0], box.lower[1]}, box.upper, {box.lower[0], box.upper[1]}};
    std::vector<NurbsCurve> sides;
    for (int i = 0; i < 4; ++i) {
        Points ends = Points::Zero(2, 3);
        ends.row(0).head<2>() = corners[i];
        ends.row(1).head<2>() = corners[(i + 1) % 4];
        sides.emplace_back(KnotVector::uniform(1, 1), std::move(ends));
    }
    return TrimmingLoop(LoopKind::outer, std::move(sides));
}

} // namespace tokay::geometry
