// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/CurveOnSurface.hpp"

#include "common/errors.hpp"
#include "geometry/bezier/PlaneBezier.hpp"
#include "geometry/bezier/parameterCrossings.hpp"
#include "geometry/projection/closestOfPieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace tokay::geometry {

namespace {

/// Lower and upper end of a coordinate of the curve (not of its control points).
Eigen::Vector2d extent(const NurbsCurve& curve, int axis) {
    const double start = curve.point(curve.knotVector().first())[axis];
    Eigen::Vector2d range(start, start);
    for (const PlaneBezier& piece : PlaneBezier::piecesOf(curve)) {
        std::vector<double> values = {piece.end()[axis]};
        for (const double t : piece.extrema(axis)) {
            values.push_back(piece.point(t)[axis]);
        }
        for (const double value : values) {
            range = {std::min(range[0], value), std::max(range[1], value)};
        }
    }
    return range;
}

void checkInside(const NurbsCurve& curve, const NurbsSurface& surface) {
    const KnotVector* ranges[2] = {&surface.u(), &surface.v()};
    for (int axis = 0; axis < 2; ++axis) {
        const double first = ranges[axis]->first(), last = ranges[axis]->last();
        const double slack = 1e-9 * (last - first);
        const Eigen::Vector2d reached = extent(curve, axis);
        if (reached[0] < first - slack || reached[1] > last + slack) {
            throw InputError(
                fmt::format("a trimming curve reaches {} = {} to {}, outside the patch's "
                            "range {} to {}",
                            axis == 0 ? "xi" : "eta", reached[0], reached[1], first, last));
        }
    }
}

std::vector<double> smoothRanges(const NurbsCurve& curve, const NurbsSurface& surface) {
    std::vector<double> all = curve.knotVector().breakpoints();
    const KnotVector* directions[2] = {&surface.u(), &surface.v()};
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = 1; i < directions[axis]->nSpans(); ++i) {
            const double knot = directions[axis]->breakpoints()[i];
            const std::vector<double> found = parameterCrossings(curve, axis, knot);
            all.insert(all.end(), found.begin(), found.end());
        }
    }
    std::sort(all.begin(), all.end());
    // Through a corner of two knot lines: one breakpoint, not two a rounding apart.
    const double least = 1e-12 * (all.back() - all.front());
    std::vector<double> distinct = {all.front()};
    for (const double t : all) {
        if (t > distinct.back() + least) {
            distinct.push_back(t);
        }
    }
    distinct.back() = all.back();
    return distinct;
}

Points derivativesOn(const NurbsSurface& surface, const NurbsCurve& curve, double t, int n) {
    const Points c = curve.derivatives(t, n);
    const Points s = surface.derivatives(c(0, 0), c(0, 1), n);
    Points d(n + 1, 3);
    d.row(0) = s.row(0);
    if (n >= 1) {
        d.row(1) = s.row(1) * c(1, 0) + s.row(2) * c(1, 1);
    }
    if (n == 2) {
        d.row(2) = s.row(derivativeRow(2, 0)) * c(1, 0) * c(1, 0) +
                   s.row(derivativeRow(1, 1)) * 2 * c(1, 0) * c(1, 1) +
                   s.row(derivativeRow(0, 2)) * c(1, 1) * c(1, 1) + s.row(1) * c(2, 0) +
                   s.row(2) * c(2, 1);
    }
    return d;
}

} // namespace

CurveOnSurface::CurveOnSurface(NurbsCurve parameterCurve, NurbsSurface surface)
    : curve_(std::move(parameterCurve)), surface_(std::move(surface)),
      centre_(Box::around(surface_.controlPoints()).centre()),
      centred_(
          surface_.withControlPoints(surface_.controlPoints().rowwise() - centre_.transpose())) {
    checkInside(curve_, surface_);
    breakpoints_ = smoothRanges(curve_, surface_);
    buildTree();
}

Points CurveOnSurface::derivatives(double t, int n) const {
    assert(n <= 2);
    return derivativesOn(surface_, curve_, t, n);
}

void CurveOnSurface::buildTree() {
    // Segments this short are nearly straight; their boxes, of 4 chords and as
    // much again around them, hold what bends away from the chords.
    constexpr int nSegments = 8, nChords = 4;
    box_ = Box::empty();
    std::vector<Box> boxes;
    for (std::size_t i = 0; i + 1 < breakpoints_.size(); ++i) {
        for (int j = 0; j < nSegments; ++j) {
            const double length = (breakpoints_[i + 1] - breakpoints_[i]) / nSegments;
            const Segment segment{breakpoints_[i] + j * length, breakpoints_[i] + (j + 1) * length};
            Box box = Box::empty();
            for (int k = 0; k <= nChords; ++k) {
                box.include(
                    derivativesOn(centred_, curve_, segment.from + length * k / nChords, 0).row(0));
            }
            const Point margin = Point::Constant(box.diagonal() / nChords);
            boxes.push_back({box.lower - margin, box.upper + margin});
            segments_.push_back(segment);
            box_.include(boxes.back());
        }
    }
    tree_ = std::make_unique<BoxTree>(boxes);
    size_ = box_.diagonal();
    box_ = {box_.lower + centre_, box_.upper + centre_};
}

CurveProjection CurveOnSurface::closest(const Point& point) const {
    using Parameter = Eigen::Matrix<double, 1, 1>;
    const Point centred = point - centre_;
    const auto osculate = [&](const Parameter& t) {
        const Points d = derivativesOn(centred_, curve_, t[0], 2);
        Osculation<1> at;
        at.offset = d.row(0).transpose() - centred;
        at.tangents = d.row(1).transpose();
        at.curvature(0, 0) = d.row(2).dot(at.offset);
        return at;
    };
    return closestOfPieces(*tree_, centred, size_, [&](int number) {
        const Segment& segment = segments_[number];
        return closestParameter<1>(osculate, Parameter(segment.from), Parameter(segment.to),
                                   Parameter(0.5 * (segment.from + segment.to)), size_);
    });
}

} // namespace tokay::geometry
