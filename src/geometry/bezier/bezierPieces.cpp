// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/bezierPieces.hpp"

#include "geometry/spline/refinement.hpp"

namespace tokay::geometry {

namespace {

/// Knots that make every inner breakpoint degree-fold.
std::vector<double> separatingKnots(const KnotVector& knots) {
    std::vector<double> added;
    for (int i = 1; i < knots.nSpans(); ++i) {
        const double knot = knots.breakpoints()[i];
        added.insert(added.end(), knots.degree() - knots.multiplicity(knot), knot);
    }
    return added;
}

KnotVector singleSpan(const KnotVector& knots, int span) {
    return KnotVector::uniform(knots.degree(), 1, knots.breakpoints()[span],
                               knots.breakpoints()[span + 1]);
}

} // namespace

std::vector<NurbsCurve> bezierPieces(const NurbsCurve& curve) {
    const NurbsCurve separated = insertKnots(curve, separatingKnots(curve.knotVector()));
    const int p = curve.degree();
    std::vector<NurbsCurve> pieces;
    for (int span = 0; span < curve.knotVector().nSpans(); ++span) {
        Eigen::VectorXd weights;
        if (separated.isRational()) {
            weights = separated.weights().segment(p * span, p + 1);
        }
        pieces.emplace_back(singleSpan(curve.knotVector(), span),
                            separated.controlPoints().middleRows(p * span, p + 1), weights);
    }
    return pieces;
}

std::vector<NurbsSurface> bezierPieces(const NurbsSurface& surface) {
    const KnotVector &u = surface.u(), &v = surface.v();
    const NurbsSurface separated = insertKnots(surface, separatingKnots(u), separatingKnots(v));
    const int p = u.degree(), q = v.degree(), nU = separated.u().nBasis();

    std::vector<NurbsSurface> pieces;
    pieces.reserve(u.nSpans() * v.nSpans());
    std::vector<int> numbers((p + 1) * (q + 1));
    for (int spanV = 0; spanV < v.nSpans(); ++spanV) {
        for (int spanU = 0; spanU < u.nSpans(); ++spanU) {
            for (int j = 0; j <= q; ++j) {
                for (int i = 0; i <= p; ++i) {
                    numbers[i + (p + 1) * j] = p * spanU + i + nU * (q * spanV + j);
                }
            }
            Eigen::VectorXd weights;
            if (separated.isRational()) {
                weights = separated.weights()(numbers);
            }
            pieces.emplace_back(singleSpan(u, spanU), singleSpan(v, spanV),
                                separated.controlPoints()(numbers, Eigen::all), weights);
        }
    }
    return pieces;
}

} // namespace tokay::geometry
