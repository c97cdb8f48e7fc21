// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/parameterCrossings.hpp"

#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/spline/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::geometry {

namespace {

/// Root by bisection: the signs at the ends differ.
double bracketedCrossing(const NurbsCurve& piece, int axis, double value) {
    double from = piece.knotVector().first(), to = piece.knotVector().last();
    const bool rises = piece.point(to)[axis] > value;
    while (true) {
        const double middle = 0.5 * (from + to);
        if (middle <= from || middle >= to) {
            return to;
        }
        if ((piece.point(middle)[axis] > value) == rises) {
            to = middle;
        } else {
            from = middle;
        }
    }
}

int signChanges(const Eigen::VectorXd& coefficients) {
    int changes = 0;
    double last = 0;
    for (const double c : coefficients) {
        if (c * last < 0) {
            ++changes;
        }
        if (c != 0) {
            last = c;
        }
    }
    return changes;
}

/// A Bezier curve crosses at most as often as its control polygon does.
void collect(const NurbsCurve& piece, int axis, double value, int depth,
             std::vector<double>& crossings) {
    const Eigen::VectorXd coefficients = piece.controlPoints().col(axis).array() - value;
    const int changes = signChanges(coefficients);
    const double first = coefficients[0], last = coefficients[coefficients.size() - 1];
    constexpr int deepest = 40;
    if (changes == 1 && first * last < 0) {
        crossings.push_back(bracketedCrossing(piece, axis, value));
    } else if (changes > 0 && depth < deepest) {
        const KnotVector& knots = piece.knotVector();
        const double middle = 0.5 * (knots.first() + knots.last());
        if (piece.point(middle)[axis] == value) {
            crossings.push_back(middle);
        }
        for (const NurbsCurve& half : bezierPieces(insertKnots(piece, {middle}))) {
            collect(half, axis, value, depth + 1, crossings);
        }
    }
}

} // namespace

std::vector<double> parameterCrossings(const NurbsCurve& curve, int axis, double value) {
    std::vector<double> crossings;
    for (const NurbsCurve& piece : bezierPieces(curve)) {
        collect(piece, axis, value, 0, crossings);
        // A crossing exactly between two pieces is an end of both.
        if (piece.point(piece.knotVector().first())[axis] == value &&
            signChanges(piece.controlPoints().col(axis).array() - value) == 0 &&
            (piece.controlPoints().col(axis).array() != value).any()) {
            crossings.push_back(piece.knotVector().first());
        }
    }
    std::sort(crossings.begin(), crossings.end());
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
    return crossings;
}

} // namespace tokay::geometry
