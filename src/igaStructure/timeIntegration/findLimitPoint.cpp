// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/findLimitPoint.hpp"

#include "common/errors.hpp"
#include "igaStructure/timeIntegration/ArcLength.hpp"

#include <array>

namespace tokay::structure {

namespace {

/// A point of the path: its time over the length from the start.
struct PathPoint {
    double length = 0;
    double time = 0;
};

// The maximum of the parabola through three points, the middle one of which is the highest.
double maximum(const std::array<PathPoint, 3>& points) {
    const double left = points[0].length - points[1].length;
    const double right = points[2].length - points[1].length;
    const double slopeLeft = (points[0].time - points[1].time) / left;
    const double slopeRight = (points[2].time - points[1].time) / right;
    const double curvature = (slopeRight - slopeLeft) / (right - left);
    const double slope = slopeLeft - curvature * left;
    return curvature < 0 ? points[1].time - 0.25 * slope * slope / curvature : points[1].time;
}

} // namespace

std::optional<double> findLimitPoint(StructuralModel& model, const NewtonOptions& newton,
                                     const MotionState& from, double until) {
    constexpr int maxSteps = 100;
    constexpr int parts = 8; // the failed step shows that the path bends within it
    // Arcs of one length, as accurate as the first.
    const EquilibriumPath path{maxSteps, 1};
    ArcLength arcs(model, newton, path, (until - from.time) / parts, until);
    arcs.restart(from);
    std::array<PathPoint, 3> last = {PathPoint{0, from.time}, {0, from.time}, {0, from.time}};
    try {
        for (int step = 0; step < maxSteps && arcs.state().time < until; ++step) {
            const Eigen::VectorXd before = arcs.state().displacement;
            arcs.advance();
            const double arc = (arcs.state().displacement - before).norm();
            last = {last[1], last[2], {last[2].length + arc, arcs.state().time}};
            if (last[2].time < last[1].time) {
                return step == 0 ? last[1].time : maximum(last);
            }
        }
    } catch (const SolverError&) {
        return std::nullopt; // the caller has an error of its own to report
    }
    return std::nullopt;
}

} // namespace tokay::structure
