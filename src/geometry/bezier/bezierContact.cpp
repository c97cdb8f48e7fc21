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

} // namespace

std::optional<Parameters> contact(const PlaneBezier& a, const PlaneBezier& b, double tolerance) {
    if (areApart(a, b, tolerance)) {
        return std::nullopt;
    }
    const double sizeA = size(a), sizeB = size(b);
    if (!(std::max(sizeA, sizeB) > tolerance)) {
        return a.start();
    }
    if (sizeA >= sizeB) {
        for (const PlaneBezier& half : a.split(0.5)) {
            if (const auto found = contact(half, b, tolerance)) {
                return found;
            }
        }
    } else {
        for (const PlaneBezier& half : b.split(0.5)) {
            if (const auto found = contact(a, half, tolerance)) {
                return found;
            }
        }
    }
    return std::nullopt;
}

std::optional<Parameters> contactBesideJoint(const PlaneBezier& a, const PlaneBezier& b,
                                             double tolerance) {
    const double smaller = std::min(size(a), size(b));
    // The sides of a cusp are apart by the square of the distance to the joint;
    // nearer to it than this that is lost in rounding.
    constexpr double nearest = 1e-6;
    if (areApartBesideJoint(a, b, tolerance) || !(smaller > nearest)) {
        return std::nullopt;
    }
    const double between = std::min(tolerance, 1e-3 * smaller * smaller);
    const auto halvesA = a.split(0.5), halvesB = b.split(0.5);
    if (const auto found = contact(halvesA[0], halvesB[0], between)) {
        return found;
    }
    if (const auto found = contact(halvesA[0], halvesB[1], between)) {
        return found;
    }
    if (const auto found = contact(halvesA[1], halvesB[1], between)) {
        return found;
    }
    return contactBesideJoint(halvesA[1], halvesB[0], tolerance);
}

} // namespace tokay::geometry
