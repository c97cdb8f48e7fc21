// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/bezierContact.hpp"

#include <limits>

namespace tokay::geometry {

namespace {

/// Extent of the control points, and so of the curve, along a direction.
struct Range {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();
};

Range range(const PlaneBezier& curve, const Parameters& direction, const Parameters& origin) {
    Range range;
    for (int i = 0; i <= curve.degree(); ++i) {
        const double x = direction.dot(curve.controlPoint(i) - origin);
        range.lower = std::min(range.lower, x);
        range.upper = std::max(range.upper, x);
    }
    return range;
}

double size(const PlaneBezier& curve) {
    return curve.box().size().maxCoeff();
}

Parameters direction(const Parameters& vector) {
    const double length = vector.norm();
    return length > 0 ? Parameters(vector / length) : Parameters(1, 0);
}

Parameters normal(const Parameters& vector) {
    const Parameters d = direction(vector);
    return {-d[1], d[0]};
}

bool areApart(const PlaneBezier& a, const PlaneBezier& b, double tolerance) {
    const Parameters axes[4] = {
        {1, 0}, {0, 1}, normal(a.end() - a.start()), normal(b.end() - b.start())};
    for (const Parameters& axis : axes) {
        const Range ofA = range(a, axis, a.start()), ofB = range(b, axis, a.start());
        if (ofA.upper + tolerance < ofB.lower || ofB.upper + tolerance < ofA.lower) {
            return true;
        }
    }
    return false;
}

/// A line through the joint with a on one side and b on the other, of which not
/// both lie on the line (a spike).
bool areApartBesideJoint(const PlaneBezier& a, const PlaneBezier& b, double tolerance) {
    const Parameters joint = b.start();
    const Parameters awayA = direction(a.start() - joint), awayB = direction(b.end() - joint);
    const double slack = 1e-15 * joint.cwiseAbs().maxCoeff();
    for (const Parameters& axis : {Parameters(awayA - awayB), normal(awayA), normal(awayB),
                                   Parameters(1, 0), Parameters(0, 1)}) {
        const Range ofA = range(a, axis, joint), ofB = range(b, axis, joint);
        const bool aBelow = ofA.upper <= slack && ofB.lower >= -slack;
        const bool bBelow = ofB.upper <= slack && ofA.lower >= -slack;
        if (aBelow && std::max(-ofA.lower, ofB.upper) > tolerance) {
            return true;
        }
        if (bBelow && std::max(-ofB.lower, ofA.upper) > tolerance) {
            return true;
        }
    }
    return false;
}

/// Halvings after which pieces that still seem to meet do: they cannot get shorter.
constexpr int mostHalvings = 200;

std::optional<Parameters> contactOfParts(const PlaneBezier& a, const PlaneBezier& b,
                                         double tolerance, int depth) {
    if (areApart(a, b, tolerance)) {
        return std::nullopt;
    }
    const double sizeA = size(a), sizeB = size(b);
    if (!(std::max(sizeA, sizeB) > tolerance) || depth == mostHalvings) {
        return a.start();
    }
    const bool halvesA = sizeA >= sizeB;
    for (const PlaneBezier& half : (halvesA ? a : b).split(0.5)) {
        const auto found = halvesA ? contactOfParts(half, b, tolerance, depth + 1)
                                   : contactOfParts(a, half, tolerance, depth + 1);
        if (found) {
            return found;
        }
    }
    return std::nullopt;
}

std::optional<Parameters> contactBesideJoint(const PlaneBezier& a, const PlaneBezier& b,
                                             double tolerance, int depth) {
    const double smaller = std::min(size(a), size(b));
    // The sides of a cusp are apart by the square of the distance to the joint;
    // nearer to it than this that is lost in rounding.
    constexpr double nearest = 1e-6;
    if (areApartBesideJoint(a, b, tolerance) || !(smaller > nearest)) {
        return std::nullopt;
    }
    if (depth == mostHalvings) {
        return b.start();
    }
    const double between = std::min(tolerance, 1e-3 * smaller * smaller);
    const auto halvesA = a.split(0.5), halvesB = b.split(0.5);
    for (const auto& [first, second] : {std::pair(0, 0), std::pair(0, 1), std::pair(1, 1)}) {
        if (const auto found = contact(halvesA[first], halvesB[second], between)) {
            return found;
        }
    }
    return contactBesideJoint(halvesA[1], halvesB[0], tolerance, depth + 1);
}

} // namespace

std::optional<Parameters> contact(const PlaneBezier& a, const PlaneBezier& b, double tolerance) {
    return contactOfParts(a, b, tolerance, 0);
}

std::optional<Parameters> contactBesideJoint(const PlaneBezier& a, const PlaneBezier& b,
                                             double tolerance) {
    return contactBesideJoint(a, b, tolerance, 0);
}

} // namespace tokay::geometry
