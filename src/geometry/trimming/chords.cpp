// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/chords.hpp"

#include <algorithm>

namespace tokay::geometry {

namespace {

double distance(const Point& point, const Point& a, const Point& b) {
    const Point chord = b - a;
    const double squared = chord.squaredNorm();
    const double t = squared > 0 ? std::clamp((point - a).dot(chord) / squared, 0.0, 1.0) : 0;
    return (a + t * chord - point).norm();
}

struct Chopper {
    std::function<Point(double)> point;
    double tolerance;
    std::vector<double> parameters;

    /// Appends the parameters after from, up to and with to. Quarter points catch an
    /// inflection in the middle.
    void chop(double from, const Point& a, double to, const Point& b, int depth) {
        constexpr int deepest = 20;
        const double middle = 0.5 * (from + to);
        const Point centre = point(middle);
        const double sag =
            std::max({distance(centre, a, b), distance(point(0.5 * (from + middle)), a, b),
                      distance(point(0.5 * (middle + to)), a, b)});
        if (sag <= tolerance || depth == deepest) {
            parameters.push_back(to);
            return;
        }
        chop(from, a, middle, centre, depth + 1);
        chop(middle, centre, to, b, depth + 1);
    }
};

std::vector<double> chopped(const std::vector<double>& breakpoints,
                            std::function<Point(double)> point, double tolerance) {
    Chopper chopper{std::move(point), tolerance, {breakpoints.front()}};
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        chopper.chop(breakpoints[i], chopper.point(breakpoints[i]), breakpoints[i + 1],
                     chopper.point(breakpoints[i + 1]), 0);
    }
    return chopper.parameters;
}

} // namespace

std::vector<double> chordParameters(const NurbsCurve& curve, double tolerance) {
    return chopped(
        curve.knotVector().breakpoints(), [&](double t) { return curve.point(t); }, tolerance);
}

std::vector<double> chordParameters(const CurveOnSurface& curve, double tolerance) {
    return chopped(
        curve.breakpoints(), [&](double t) { return Point(curve.derivatives(t, 0).row(0)); },
        tolerance);
}

} // namespace tokay::geometry
