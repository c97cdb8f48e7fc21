// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/BrepModel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

/// A trimming curve with what a comparison needs.
struct Candidate {
    BrepTrim trim;
    std::string name;
    CurveOnSurface curve;
    Point start, end;
    bool isTaken = false;
};

Point pointAt(const CurveOnSurface& curve, double share) {
    const double from = curve.breakpoints().front(), to = curve.breakpoints().back();
    return curve.derivatives(from + share * (to - from), 0).row(0);
}

std::vector<Candidate> candidates(const std::vector<BrepFace>& faces) {
    std::vector<Candidate> result;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        int number = 0;
        for (const TrimmingLoop& loop : faces[f].patch.loops()) {
            for (const NurbsCurve& curve : loop.curves()) {
                CurveOnSurface inSpace(curve, faces[f].patch.surface());
                const Point start = pointAt(inSpace, 0), end = pointAt(inSpace, 1);
                result.push_back({{static_cast<int>(f), number},
                                  fmt::format("{}.{}", faces[f].patch.name(), number),
                                  std::move(inSpace),
                                  start,
                                  end});
                ++number;
            }
        }
    }
    return result;
}

bool sharesEnds(const Candidate& a, const Candidate& b, double tolerance) {
    const auto near = [&](const Point& p, const Point& q) { return (p - q).norm() <= tolerance; };
    return (near(a.start, b.start) && near(a.end, b.end)) ||
           (near(a.start, b.end) && near(a.end, b.start));
}

bool liesOn(const CurveOnSurface& a, const CurveOnSurface& b, double tolerance) {
    constexpr int nSamples = 17;
    for (int i = 0; i < nSamples; ++i) {
        const Point point = pointAt(a, static_cast<double>(i) / (nSamples - 1));
        if (b.closest(point).distance > tolerance) {
            return false;
        }
    }
    return true;
}

/// A pole: the whole curve is one point.
bool isPoint(const CurveOnSurface& curve, double tolerance) {
    return curve.box().diagonal() <= tolerance;
}

} // namespace

bool runsAlong(const CurveOnSurface& first, const CurveOnSurface& second) {
    // By the points a quarter from each end: the ends themselves may be one point.
    const Point a = pointAt(first, 0.25), b = pointAt(first, 0.75);
    const Point c = pointAt(second, 0.25), d = pointAt(second, 0.75);
    return (a - c).squaredNorm() + (b - d).squaredNorm() <=
           (a - d).squaredNorm() + (b - c).squaredNorm();
}

std::vector<BrepEdge> coincidentEdges(const std::vector<BrepFace>& faces, double tolerance) {
    std::vector<Candidate> all = candidates(faces);
    std::vector<BrepEdge> edges;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].isTaken || isPoint(all[i].curve, tolerance)) {
            continue;
        }
        BrepEdge edge{all[i].name, {all[i].trim}};
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (!all[j].isTaken && sharesEnds(all[i], all[j], tolerance) &&
                liesOn(all[i].curve, all[j].curve, tolerance)) {
                BrepTrim trim = all[j].trim;
                trim.isForward = runsAlong(all[i].curve, all[j].curve);
                edge.name += "-" + all[j].name;
                edge.trims.push_back(trim);
                all[j].isTaken = true;
            }
        }
        edges.push_back(std::move(edge));
    }
    return edges;
}

namespace {

bool isSame(const BrepTrim& a, const BrepTrim& b) {
    return a.face == b.face && a.curve == b.curve;
}

/// Whether one edge of the model has both trims.
bool shareEdge(const BrepModel& model, const BrepTrim& a, const BrepTrim& b) {
    const auto has = [](const BrepEdge& edge, const BrepTrim& trim) {
        return std::any_of(edge.trims.begin(), edge.trims.end(),
                           [&](const BrepTrim& own) { return isSame(own, trim); });
    };
    return std::any_of(model.edges().begin(), model.edges().end(),
                       [&](const BrepEdge& edge) { return has(edge, a) && has(edge, b); });
}

} // namespace

BrepModel withCoincidentEdges(const BrepModel& model, double tolerance) {
    std::vector<BrepEdge> edges = model.edges();
    for (BrepEdge& found : coincidentEdges(model.faces(), tolerance)) {
        const BrepTrim first = found.trims.front();
        const auto isKnown = [&](const BrepTrim& trim) {
            return !isSame(first, trim) && shareEdge(model, first, trim);
        };
        found.trims.erase(std::remove_if(found.trims.begin(), found.trims.end(), isKnown),
                          found.trims.end());
        if (found.trims.size() > 1) {
            found.isFound = true;
            edges.push_back(std::move(found));
        }
    }
    return BrepModel(model.faces(), std::move(edges), model.tolerance(), model.remarks());
}

} // namespace tokay::geometry
