#include "geometry/tessellation.hpp"

namespace tokay::geometry {

namespace {

/// Distance of a point from the segment a-b.
double distance(const Point& point, const Point& a, const Point& b) {
    const Point chord = b - a;
    const double squared = chord.squaredNorm();
    const double t =
        squared > 0 ? std::min(1.0, std::max(0.0, (point - a).dot(chord) / squared)) : 0;
    return (a + t * chord - point).norm();
}

struct Tessellator {
    const NurbsCurve& curve;
    double tolerance;
    Point inverseScales;
    std::vector<double> parameters;

    Point at(double t) const { return curve.point(t).cwiseProduct(inverseScales); }

    /// Adds what lies after from, up to and with to. Quarter points catch an
    /// inflection in the middle.
    void add(double from, const Point& a, double to, const Point& b, int depth) {
        const double middle = 0.5 * (from + to);
        const Point centre = at(middle);
        const double deviation =
            std::max({distance(centre, a, b), distance(at(0.5 * (from + middle)), a, b),
                      distance(at(0.5 * (middle + to)), a, b)});
        constexpr int deepest = 24;
        if (deviation <= tolerance || depth == deepest) {
            parameters.push_back(to);
            return;
        }
        add(from, a, middle, centre, depth + 1);
        add(middle, centre, to, b, depth + 1);
    }
};

} // namespace

std::vector<double> tessellation(const NurbsCurve& curve, double tolerance, const Point& scales) {
    const std::vector<double>& breakpoints = curve.knotVector().breakpoints();
    Tessellator tessellator{curve, tolerance, scales.cwiseInverse(), {breakpoints.front()}};
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i)
        tessellator.add(breakpoints[i], tessellator.at(breakpoints[i]), breakpoints[i + 1],
                        tessellator.at(breakpoints[i + 1]), 0);
    return tessellator.parameters;
}

} // namespace tokay::geometry
