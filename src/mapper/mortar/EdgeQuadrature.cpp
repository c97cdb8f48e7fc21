// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/EdgeQuadrature.hpp"

#include "mapper/intersection/curveIntersection.hpp"

#include <algorithm>
#include <map>

namespace tokay::mapper {

namespace {

/// A function whose values on the edge are all smaller is rounding: it stands for what a
/// trimming line leaves of an element, and moves the edge by no more.
constexpr double vanishing = 1e-14;

std::map<int, double> largestValues(const std::vector<CommonPoint>& points) {
    std::map<int, double> largest;
    for (const CommonPoint& at : points) {
        for (std::size_t k = 0; k < at.to.values.size(); ++k) {
            double& value = largest[at.to.values[k]];
            value = std::max(value, std::abs(at.to.weights[static_cast<Eigen::Index>(k)]));
        }
    }
    return largest;
}

// Gauss points lie on both edges, so they do not show that the edge which is met goes on
// beyond the other one.
void requireWithin(const CurveInterface& from, const CurveInterface& to, const GapLimit& limit) {
    GapStatistics gaps(limit, from.size());
    for (int i = 0; i < from.nCurves(); ++i) {
        for (const double xi : from.curve(i).breakpoints()) {
            const Point end = from.curve(i).derivatives(xi, 0).row(0);
            const Location place = to.locate(end);
            gaps.count(end, place.gap, place.converged, place.ambiguous);
        }
    }
    MappingReport report;
    gaps.enter(report);
}

} // namespace

EdgeQuadrature::EdgeQuadrature(const CurveInterface& from, const CurveInterface& to,
                               const GapLimit& gapLimit) {
    std::vector<CommonPoint> points;
    GapStatistics gaps(gapLimit, from.size());
    visitCommonPoints(
        from, to, {gapLimit},
        [&](const CommonPoint& at) {
            gaps.count(at.position, at.from.gap, at.from.converged, at.from.ambiguous, at.weight);
            points.push_back(at);
        },
        [] {});
    MappingReport report;
    gaps.enter(report);
    requireWithin(from, to, gapLimit);
    largestGap_ = report.largestGap;

    std::map<int, Eigen::Index> columns;
    for (const auto& [function, value] : largestValues(points)) {
        if (value > vanishing) {
            columns[function] = static_cast<Eigen::Index>(functions_.size());
            functions_.push_back(function);
        }
    }
    const auto n = static_cast<Eigen::Index>(points.size());
    points_.resize(n, 3);
    weights_.resize(n);
    values_.setZero(n, static_cast<Eigen::Index>(functions_.size()));
    for (Eigen::Index i = 0; i < n; ++i) {
        const CommonPoint& at = points[static_cast<std::size_t>(i)];
        points_.row(i) = at.position;
        weights_[i] = at.weight;
        for (std::size_t k = 0; k < at.to.values.size(); ++k) {
            if (const auto column = columns.find(at.to.values[k]); column != columns.end()) {
                values_(i, column->second) += at.to.weights[static_cast<Eigen::Index>(k)];
            }
        }
    }
}

Eigen::MatrixXd EdgeQuadrature::massMatrix() const {
    return values_.transpose() * weights_.asDiagonal() * values_;
}

} // namespace tokay::mapper
