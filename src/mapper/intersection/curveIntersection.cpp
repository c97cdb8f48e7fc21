// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/curveIntersection.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"

#include <algorithm>

namespace tokay::mapper {

namespace {

/// Where the source's elements end on each curve of the destination.
std::vector<std::vector<double>>
projectedBreakpoints(const CurveInterface& from, const CurveInterface& to, const GapLimit& limit) {
    std::vector<std::vector<double>> cuts(to.nCurves());
    for (int i = 0; i < from.nCurves(); ++i) {
        for (const double xi : from.curve(i).breakpoints()) {
            const Point point = from.curve(i).derivatives(xi, 0).row(0);
            const CurveInterface::Projection found = to.closest(point);
            if (found.onCurve.distance <= limit.relative * from.size()) {
                cuts[found.piece].push_back(found.onCurve.xi);
            }
        }
    }
    return cuts;
}

/// Ends of the intervals of an element: its own and the cuts inside it. Cuts
/// that are a rounding from another end make no interval of their own.
std::vector<double> intervals(double first, double last, const std::vector<double>& cuts) {
    const double least = 1e-11 * (last - first);
    std::vector<double> ends = {first};
    for (const double cut : cuts) {
        if (cut > ends.back() + least && cut < last - least) {
            ends.push_back(cut);
        }
    }
    ends.push_back(last);
    return ends;
}

int nGaussPoints(int degreeTo, int degreeFrom, int nExtra) {
    return std::max(degreeTo, (degreeTo + degreeFrom + 1) / 2) + 1 + nExtra;
}

int largestDegree(const CurveInterface& interface) {
    int degree = 0;
    for (int i = 0; i < interface.nCurves(); ++i) {
        degree = std::max(degree, interface.curve(i).degree());
    }
    return degree;
}

} // namespace

void visitCommonPoints(const CurveInterface& from, const CurveInterface& to,
                       const CommonIntervals& common,
                       const std::function<void(const CommonPoint&)>& visit,
                       const std::function<void()>& endElement) {
    std::vector<std::vector<double>> cuts = projectedBreakpoints(from, to, common.gapLimit);
    const int degreeFrom = largestDegree(from);

    const auto visitInterval = [&](const InterfaceCurve& curve, double first, double last) {
        const auto& rule =
            geometry::gaussLegendre(nGaussPoints(curve.degree(), degreeFrom, common.nExtraPoints));
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const double xi = first + (last - first) * rule.points[k];
            const Points d = curve.derivatives(xi, 1);
            const double weight = rule.weights[k] * (last - first) * d.row(1).norm();
            visit({d.row(0), weight, curve.functions(xi), from.locate(d.row(0))});
        }
    };
    for (int i = 0; i < to.nCurves(); ++i) {
        std::sort(cuts[i].begin(), cuts[i].end());
        const std::vector<double>& elements = to.curve(i).breakpoints();
        for (std::size_t e = 0; e + 1 < elements.size(); ++e) {
            const std::vector<double> ends = intervals(elements[e], elements[e + 1], cuts[i]);
            for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
                visitInterval(to.curve(i), ends[k], ends[k + 1]);
            }
            endElement();
        }
    }
}

void integrateIntersection(const CurveInterface& from, const CurveInterface& to,
                           const GapLimit& gapLimit, int nExtraPoints, MortarAssembler& assembler,
                           GapStatistics& gaps) {
    visitCommonPoints(
        from, to, {gapLimit, nExtraPoints},
        [&](const CommonPoint& at) {
            const Location& partner = at.from;
            if (gaps.count(at.position, partner.gap, partner.converged, partner.ambiguous,
                           at.weight)) {
                assembler.add(at.weight, at.to, partner);
            } else {
                assembler.addUnmatched(at.to.values);
            }
        },
        [&] { assembler.endGroup(); });
}

} // namespace tokay::mapper
