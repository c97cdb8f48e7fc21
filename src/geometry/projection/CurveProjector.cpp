// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/CurveProjector.hpp"

#include "geometry/projection/closestOfPieces.hpp"
#include "geometry/projection/flatPieces.hpp"

namespace tokay::geometry {

namespace {

using Parameter = Eigen::Matrix<double, 1, 1>;

Osculation<1> osculation(const NurbsCurve& curve, double xi, const Point& point) {
    const Points d = curve.derivatives(xi, 2);
    Osculation<1> at;
    at.offset = d.row(0).transpose() - point;
    at.tangents = d.row(1).transpose();
    at.curvature(0, 0) = d.row(2).dot(at.offset);
    return at;
}

/// Closest place of the piece's chord; the better end if the piece bends away.
double start(const NurbsCurve& piece, const Point& point) {
    const Points& points = piece.controlPoints();
    const Point a = points.row(0), b = points.row(points.rows() - 1);
    const double from = piece.knotVector().first(), to = piece.knotVector().last();
    const double squaredChord = (b - a).squaredNorm();
    const double t = squaredChord > 0 ? (point - a).dot(b - a) / squaredChord : 0.5;
    const double xi = from + (to - from) * std::clamp(t, 0.0, 1.0);
    const double distance = (piece.point(xi) - point).squaredNorm();
    const double toStart = (a - point).squaredNorm(), toEnd = (b - point).squaredNorm();
    if (distance <= std::min(toStart, toEnd)) {
        return xi;
    }
    return toStart < toEnd ? from : to;
}

ClosestParameter<1> closestIn(const NurbsCurve& piece, const Point& point, double size) {
    return closestParameter<1>([&](const Parameter& xi) { return osculation(piece, xi[0], point); },
                               Parameter(piece.knotVector().first()),
                               Parameter(piece.knotVector().last()), Parameter(start(piece, point)),
                               size);
}

} // namespace

CurveProjector::CurveProjector(const NurbsCurve& curve) {
    const Box box = Box::around(curve.controlPoints());
    centre_ = box.centre();
    size_ = box.diagonal();
    pieces_ =
        flatPieces(curve.withControlPoints(curve.controlPoints().rowwise() - centre_.transpose()));
    std::vector<Box> boxes;
    for (const NurbsCurve& piece : pieces_) {
        boxes.push_back(Box::around(piece.controlPoints()));
    }
    tree_ = std::make_unique<BoxTree>(boxes);
}

CurveProjection CurveProjector::closest(const Point& point) const {
    const Point centred = point - centre_;
    return closestOfPieces(*tree_, centred, size_,
                           [&](int piece) { return closestIn(pieces_[piece], centred, size_); });
}

} // namespace tokay::geometry
