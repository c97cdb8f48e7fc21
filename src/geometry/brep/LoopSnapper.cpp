// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/LoopSnapper.hpp"

#include "geometry/projection/BoxTree.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/trimming/TrimmingLoop.hpp"

#include <algorithm>

namespace tokay::geometry {

namespace {

/// Largest lengths of the tangents along xi and eta at the ends and in the middle of
/// all knot spans.
Parameters largestSpeed(const NurbsSurface& surface) {
    const auto places = [](const KnotVector& knots) {
        std::vector<double> result = knots.breakpoints();
        for (int i = 0; i < knots.nSpans(); ++i) {
            result.push_back(0.5 * (knots.breakpoints()[i] + knots.breakpoints()[i + 1]));
        }
        return result;
    };
    const std::vector<double> xi = places(surface.u()), eta = places(surface.v());
    Parameters speed = Parameters::Zero();
    for (const double u : xi) {
        for (const double v : eta) {
            const Points d = surface.derivatives(u, v, 1);
            speed = speed.cwiseMax(Parameters(d.row(1).norm(), d.row(2).norm()));
        }
    }
    return speed;
}

} // namespace

LoopSnapper::LoopSnapper(const NurbsSurface& surface, double tolerance)
    : surface_(surface), tolerance_(tolerance), speed_(largestSpeed(surface)),
      box_{{surface.u().first(), surface.v().first()}, {surface.u().last(), surface.v().last()}} {
    for (int axis = 0; axis < 2; ++axis) {
        // A tolerance beyond a thousandth of the range would swallow the surface.
        const double most = 1e-3 * box_.size()[axis], least = 1e-9 * box_.size()[axis];
        const double wanted = speed_[axis] > 0 ? tolerance / speed_[axis] : most;
        slack_[axis] = std::clamp(wanted, least, most);
    }
    findSides();
}

void LoopSnapper::findSides() {
    const double size = Box::around(surface_.controlPoints()).diagonal();
    const auto add = [&](Edge edge, int axis, double value) {
        const Points points = surface_.boundaryCurve(edge).curve.controlPoints();
        const double length = Box::around(points).diagonal();
        sides_.push_back({axis, value, length <= std::max(tolerance_, 1e-12 * size)});
    };
    add(Edge::left, 0, box_.lower[0]);
    add(Edge::right, 0, box_.upper[0]);
    add(Edge::bottom, 1, box_.lower[1]);
    add(Edge::top, 1, box_.upper[1]);
}

std::vector<LoopCurve> LoopSnapper::snapped(std::vector<LoopCurve> curves) {
    for (LoopCurve& given : curves) {
        given.curve = onRim(given.curve);
    }
    curves = withCollapsedSides(curves);
    const std::size_t n = curves.size();
    for (std::size_t i = 0; i < n; ++i) {
        NurbsCurve &before = curves[(i + n - 1) % n].curve, &after = curves[i].curve;
        const Parameters end = endOf(before), start = startOf(after), at = joint(end, start);
        const Parameters closable = slack_.cwiseMax(TrimmingLoop::closingTolerance * box_.size());
        if (((end - start).cwiseAbs() - closable).maxCoeff() > 0) {
            continue; // open: refused by the loop, which says where
        }
        count(at - end);
        count(at - start);
        before = withEnds(before, startOf(before), at);
        after = withEnds(after, at, endOf(after));
    }
    return curves;
}

/// Control points beyond the rim within the tolerance are moved onto it, and so is a
/// curve that runs along it.
NurbsCurve LoopSnapper::onRim(const NurbsCurve& curve) {
    Points points = curve.controlPoints();
    for (const Side& side : sides_) {
        auto coordinate = points.col(side.axis).array();
        const bool isLower = side.value == box_.lower[side.axis];
        const double slack = slack_[side.axis];
        const bool runsAlong = ((coordinate - side.value).abs() <= slack).all();
        for (double& value : coordinate) {
            const double beyond = isLower ? side.value - value : value - side.value;
            if (runsAlong || (beyond > 0 && beyond <= slack)) {
                value = side.value;
            }
        }
    }
    const Points moves = points - curve.controlPoints();
    if (moves.isZero(0)) {
        return curve;
    }
    count(moves.leftCols<2>().cwiseAbs().colwise().maxCoeff().transpose());
    return curve.withControlPoints(std::move(points));
}

std::vector<LoopCurve> LoopSnapper::withCollapsedSides(const std::vector<LoopCurve>& curves) {
    std::vector<LoopCurve> result;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        result.push_back(curves[i]);
        const Parameters end = endOf(curves[i].curve);
        const Parameters start = startOf(curves[(i + 1) % curves.size()].curve);
        if (const auto along = alongCollapsedSide(end, start)) {
            result.push_back({*along, std::nullopt});
            ++statistics_.nSupplied;
        }
    }
    return result;
}

std::optional<NurbsCurve> LoopSnapper::alongCollapsedSide(const Parameters& from,
                                                          const Parameters& to) {
    for (const Side& side : sides_) {
        const int along = 1 - side.axis;
        const bool isOnSide = std::abs(from[side.axis] - side.value) <= slack_[side.axis] &&
                              std::abs(to[side.axis] - side.value) <= slack_[side.axis];
        if (side.isCollapsed && isOnSide && std::abs(from[along] - to[along]) > slack_[along]) {
            Points ends = Points::Zero(2, 3);
            ends.col(side.axis).setConstant(side.value);
            ends(0, along) = from[along];
            ends(1, along) = to[along];
            return NurbsCurve(KnotVector::uniform(1, 1), std::move(ends));
        }
    }
    return std::nullopt;
}

/// The middle, or the rim where that is within the tolerance.
Parameters LoopSnapper::joint(const Parameters& end, const Parameters& start) const {
    Parameters at = end == start ? start : Parameters(0.5 * (start + end));
    for (const Side& side : sides_) {
        if (std::abs(at[side.axis] - side.value) <= slack_[side.axis]) {
            at[side.axis] = side.value;
        }
    }
    return at;
}

void LoopSnapper::count(const Parameters& moved) {
    constexpr double rounding = 1e-12; // of the parameter range
    if ((moved.cwiseAbs().array() <= rounding * box_.size().array()).all()) {
        return;
    }
    ++statistics_.nMoved;
    statistics_.largest = std::max(statistics_.largest, distance(moved));
}

} // namespace tokay::geometry
