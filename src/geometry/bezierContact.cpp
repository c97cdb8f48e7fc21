#include "geometry/bezierContact.hpp"

#include <limits>

namespace tokay::geometry {

namespace {

/// Extent of the control points, and so of the curve, along a direction.
struct Range {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();
};

Range range(const PlaneBezier& curve, const ParameterPoint& direction,
            const ParameterPoint& origin) {
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

ParameterPoint direction(const ParameterPoint& vector) {
    const double length = vector.norm();
    return length > 0 ? ParameterPoint(vector / length) : ParameterPoint(1, 0);
}

ParameterPoint normal(const ParameterPoint& vector) {
    const ParameterPoint d = direction(vector);
    return {-d[1], d[0]};
}

bool areApart(const PlaneBezier& a, const PlaneBezier& b, double tolerance) {
    const ParameterPoint axes[4] = {
        {1, 0}, {0, 1}, normal(a.end() - a.start()), normal(b.end() - b.start())};
    for (const ParameterPoint& axis : axes) {
        const Range ofA = range(a, axis, a.start()), ofB = range(b, axis, a.start());
        if (ofA.upper + tolerance < ofB.lower || ofB.upper + tolerance < ofA.lower)
            return true;
    }
    return false;
}

/// A line through the joint with a on one side and b on the other, of which not
/// both lie on the line (a spike).
bool areApartBesideJoint(const PlaneBezier& a, const PlaneBezier& b, double tolerance) {
    const ParameterPoint joint = b.start();
    const ParameterPoint awayA = direction(a.start() - joint), awayB = direction(b.end() - joint);
    const double slack = 1e-15 * joint.cwiseAbs().maxCoeff();
    for (const ParameterPoint& axis : {ParameterPoint(awayA - awayB), normal(awayA), normal(awayB),
                                       ParameterPoint(1, 0), ParameterPoint(0, 1)}) {
        const Range ofA = range(a, axis, joint), ofB = range(b, axis, joint);
        const bool aBelow = ofA.upper <= slack && ofB.lower >= -slack;
        const bool bBelow = ofB.upper <= slack && ofA.lower >= -slack;
        if (aBelow && std::max(-ofA.lower, ofB.upper) > tolerance)
            return true;
        if (bBelow && std::max(-ofB.lower, ofA.upper) > tolerance)
            return true;
    }
    return false;
}

} // namespace

std::optional<ParameterPoint> contact(const PlaneBezier& a, const PlaneBezier& b,
                                      double tolerance) {
    if (areApart(a, b, tolerance))
        return std::nullopt;
    const double sizeA = size(a), sizeB = size(b);
    if (std::max(sizeA, sizeB) <= tolerance)
        return a.start();
    if (sizeA >= sizeB) {
        for (const PlaneBezier& half : a.split(0.5))
            if (const auto found = contact(half, b, tolerance))
                return found;
    } else {
        for (const PlaneBezier& half : b.split(0.5))
            if (const auto found = contact(a, half, tolerance))
                return found;
    }
    return std::nullopt;
}

std::optional<ParameterPoint> contactBesideJoint(const PlaneBezier& a, const PlaneBezier& b,
                                                 double tolerance) {
    if (areApartBesideJoint(a, b, tolerance) || std::min(size(a), size(b)) <= 10 * tolerance)
        return std::nullopt;
    const auto halvesA = a.split(0.5), halvesB = b.split(0.5);
    if (const auto found = contact(halvesA[0], halvesB[0], tolerance))
        return found;
    if (const auto found = contact(halvesA[0], halvesB[1], tolerance))
        return found;
    if (const auto found = contact(halvesA[1], halvesB[1], tolerance))
        return found;
    return contactBesideJoint(halvesA[1], halvesB[0], tolerance);
}

} // namespace tokay::geometry
