// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/parameterCrossings.hpp"

#include "geometry/bezier/bezierPieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tokay::geometry {

namespace {

using Eigen::VectorXd;

int signChanges(const VectorXd& coefficients) {
    int changes = 0;
    double last = 0;
    for (const double c : coefficients) {
        if (c != 0) {
            changes += last != 0 && std::signbit(c) != std::signbit(last);
            last = c;
        }
    }
    return changes;
}

/// Coefficients on both parts of a polynomial cut at t, by de Casteljau's algorithm.
std::array<VectorXd, 2> cut(const VectorXd& coefficients, double t) {
    const Eigen::Index degree = coefficients.size() - 1;
    VectorXd left(degree + 1), right = coefficients;
    for (Eigen::Index n = degree; n >= 0; --n) {
        left[degree - n] = right[0];
        right.head(n) += t * (right.segment(1, n) - right.head(n)).eval();
    }
    return {left, right};
}

/// Root by bisection: the signs at the ends differ.
double bracketedRoot(const VectorXd& coefficients) {
    double from = 0, to = 1;
    const bool rises = coefficients[coefficients.size() - 1] > 0;
    constexpr double resolution = 1e-17;
    while (to - from > resolution) {
        const double middle = 0.5 * (from + to);
        if (middle <= from || middle >= to) {
            break;
        }
        ((cut(coefficients, middle)[1][0] > 0) == rises ? to : from) = middle;
    }
    return to;
}

/// A polynomial has at most as many roots in (0, 1) as its coefficients change signs.
void collectRoots(const VectorXd& coefficients, double from, double to, int depth,
                  std::vector<double>& roots) {
    const int changes = signChanges(coefficients);
    const double first = coefficients[0], last = coefficients[coefficients.size() - 1];
    constexpr int deepest = 40;
    if (changes == 1 && first != 0 && last != 0) {
        roots.push_back(from + (to - from) * bracketedRoot(coefficients));
    } else if (changes > 0 && depth < deepest) {
        const double middle = 0.5 * (from + to);
        const auto halves = cut(coefficients, 0.5);
        if (halves[1][0] == 0) {
            roots.push_back(middle);
        }
        collectRoots(halves[0], from, middle, depth + 1, roots);
        collectRoots(halves[1], middle, to, depth + 1, roots);
    }
}

} // namespace

std::vector<double> bernsteinRoots(const VectorXd& coefficients) {
    std::vector<double> roots;
    collectRoots(coefficients, 0, 1, 0, roots);
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    return roots;
}

std::vector<double> parameterCrossings(const NurbsCurve& curve, int axis, double value) {
    std::vector<double> crossings;
    for (const NurbsCurve& piece : bezierPieces(curve)) {
        const double first = piece.knotVector().first(), last = piece.knotVector().last();
        VectorXd distances = piece.controlPoints().col(axis).array() - value;
        if (piece.isRational()) {
            distances = distances.cwiseProduct(piece.weights()).eval();
        }
        for (const double t : bernsteinRoots(distances)) {
            crossings.push_back(first + t * (last - first));
        }
        // A crossing exactly between two pieces is an end of both.
        if (distances[0] == 0 && signChanges(distances) == 0 && (distances.array() != 0).any()) {
            crossings.push_back(first);
        }
    }
    std::sort(crossings.begin(), crossings.end());
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
    return crossings;
}

} // namespace tokay::geometry
