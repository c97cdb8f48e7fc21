// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/NurbsCurve.hpp"

#include "geometry/spline/rational.hpp"

namespace tokay::geometry {

namespace {

/// Turns functions N_i into w_i N_i / sum of w_j N_j, derivative by derivative.
void makeRational(Eigen::MatrixXd& N, const Eigen::VectorXd& weights) {
    N *= weights.asDiagonal();
    const Eigen::VectorXd sums = N.rowwise().sum();
    for (int k = 0; k < N.rows(); ++k) {
        for (int i = 1; i <= k; ++i) {
            N.row(k) -= binomial(k, i) * sums[i] * N.row(k - i);
        }
        N.row(k) /= sums[0];
    }
}

} // namespace

NurbsCurve::NurbsCurve(KnotVector knots, Points controlPoints, Eigen::VectorXd weights)
    : knots_(std::move(knots)), controlPoints_(std::move(controlPoints)),
      weights_(checkedWeights(std::move(weights), knots_.nBasis(), "the curve")) {
    checkControlPoints(controlPoints_, knots_.nBasis(), "the curve");
}

CurveBasis NurbsCurve::basis(double xi, int nDerivatives) const {
    const int span = knots_.findSpan(xi), first = span - degree();
    CurveBasis basis{first, knots_.basisDerivatives(span, xi, nDerivatives)};
    if (isRational()) {
        makeRational(basis.N, weights_.segment(first, degree() + 1));
    }
    return basis;
}

Points NurbsCurve::derivatives(double xi, int n) const {
    const CurveBasis b = basis(xi, n);
    return b.N * controlPoints_.middleRows(b.first, degree() + 1);
}

Point NurbsCurve::point(double xi) const {
    return derivatives(xi, 0).row(0);
}

NurbsCurve NurbsCurve::withControlPoints(Points controlPoints) const {
    return NurbsCurve(knots_, std::move(controlPoints), weights_);
}

} // namespace tokay::geometry
