// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/curveParts.hpp"

#include "common/errors.hpp"
#include "geometry/spline/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

KnotVector reversed(const KnotVector& knots) {
    std::vector<double> turned;
    for (auto knot = knots.knots().rbegin(); knot != knots.knots().rend(); ++knot) {
        // Not first + (last - knot): the ends must keep their last bit.
        const bool isEnd = *knot == knots.first() || *knot == knots.last();
        turned.push_back(isEnd ? (*knot == knots.first() ? knots.last() : knots.first())
                               : knots.first() + (knots.last() - *knot));
    }
    return KnotVector(knots.degree(), std::move(turned));
}

} // namespace

NurbsCurve reversed(const NurbsCurve& curve) {
    Eigen::VectorXd weights;
    if (curve.isRational()) {
        weights = curve.weights().reverse();
    }
    return NurbsCurve(reversed(curve.knotVector()), curve.controlPoints().colwise().reverse(),
                      std::move(weights));
}

NurbsSurface reversedXi(const NurbsSurface& surface) {
    const int nU = surface.u().nBasis(), nV = surface.v().nBasis();
    Points points(nU * nV, 3);
    Eigen::VectorXd weights(surface.weights().size());
    for (int k = 0; k < nU * nV; ++k) {
        const int from = nU - 1 - k % nU + k / nU * nU;
        points.row(k) = surface.controlPoints().row(from);
        if (surface.isRational()) {
            weights[k] = surface.weights()[from];
        }
    }
    return NurbsSurface(reversed(surface.u()), surface.v(), std::move(points), std::move(weights));
}

NurbsCurve partOf(const NurbsCurve& curve, double from, double to) {
    const KnotVector& range = curve.knotVector();
    if (!(range.first() <= from && from < to && to <= range.last())) {
        throw InputError(fmt::format("a curve over {} to {} has no part from {} to {}",
                                     range.first(), range.last(), from, to));
    }
    std::vector<double> added;
    for (const double end : {from, to}) {
        if (end > range.first() && end < range.last()) {
            added.insert(added.end(), range.degree() - range.multiplicity(end), end);
        }
    }
    const NurbsCurve cut = insertKnots(curve, added);

    // Each end now is an open one but for one knot, which is repeated.
    const std::vector<double>& knots = cut.knotVector().knots();
    const int degree = curve.degree();
    auto begin = std::upper_bound(knots.begin(), knots.end(), from) - degree;
    auto end = std::lower_bound(knots.begin(), knots.end(), to) + degree;
    std::vector<double> inner(begin, end);
    inner.insert(inner.begin(), from);
    inner.push_back(to);
    const int first = static_cast<int>(begin - knots.begin()) - 1;
    const int n = static_cast<int>(inner.size()) - degree - 1;
    Eigen::VectorXd weights;
    if (cut.isRational()) {
        weights = cut.weights().segment(first, n);
    }
    return NurbsCurve(KnotVector(degree, std::move(inner)),
                      cut.controlPoints().middleRows(first, n), std::move(weights));
}

Parameters startOf(const NurbsCurve& parameterCurve) {
    return parameterCurve.controlPoints().row(0).head<2>();
}

Parameters endOf(const NurbsCurve& parameterCurve) {
    return parameterCurve.controlPoints().row(parameterCurve.nControlPoints() - 1).head<2>();
}

NurbsCurve withEnds(const NurbsCurve& parameterCurve, const Parameters& start,
                    const Parameters& end) {
    Points points = parameterCurve.controlPoints();
    points.row(0).head<2>() = start;
    points.row(points.rows() - 1).head<2>() = end;
    return parameterCurve.withControlPoints(std::move(points));
}

} // namespace tokay::geometry
