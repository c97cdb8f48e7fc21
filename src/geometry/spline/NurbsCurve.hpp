// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/KnotVector.hpp"
#include "geometry/spline/Points.hpp"

namespace tokay::geometry {

/// The functions of a curve that are not zero at a parameter.
struct CurveBasis {
    /// Number of the control point of the first column.
    int first;
    /// (nDerivatives + 1) x (degree + 1); row k is the k-th derivative by xi.
    Eigen::MatrixXd N;
};

/// Curve in space, C(xi) = sum of N_i(xi) P_i, with rational N if there are weights.
/// A parameter outside the knot vector's range continues the first or last span.
class NurbsCurve {
  public:
    /// @param controlPoints  nBasis x 3 [m]
    /// @param weights        nBasis, positive; empty means polynomial. Equal
    ///                       weights are dropped: the curve then is polynomial.
    /// @throws InputError if counts do not agree, a coordinate is not finite or
    /// a weight is not positive.
    NurbsCurve(KnotVector knots, Points controlPoints, Eigen::VectorXd weights = {});

    const KnotVector& knotVector() const { return knots_; }
    const Points& controlPoints() const { return controlPoints_; }
    /// Empty if the curve is polynomial.
    const Eigen::VectorXd& weights() const { return weights_; }
    bool isRational() const { return weights_.size() > 0; }
    int degree() const { return knots_.degree(); }
    int nControlPoints() const { return knots_.nBasis(); }

    Point point(double xi) const;

    /// @return (n + 1) x 3; row k is the k-th derivative by xi.
    Points derivatives(double xi, int n) const;

    /// Source: Piegl & Tiller, The NURBS Book, equation 4.8 for each function
    CurveBasis basis(double xi, int nDerivatives) const;

    /// Curve of the same functions with other control points (a deformed one).
    NurbsCurve withControlPoints(Points controlPoints) const;

  private:
    KnotVector knots_;
    Points controlPoints_;
    Eigen::VectorXd weights_;
};

} // namespace tokay::geometry
