// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"

#include <array>
#include <string>
#include <vector>

namespace tokay::geometry {

/// Edges of the parameter rectangle: left is the first xi, right the last xi,
/// bottom the first eta, top the last eta.
enum class Edge { left, right, bottom, top };

/// @throws InputError that lists the names if there is no such edge.
Edge edgeFromName(const std::string& name);
std::string nameOf(Edge edge);

/// The functions of a surface that are not zero at a parameter.
struct SurfaceBasis {
    /// Control point of each column.
    std::vector<int> controlPoints;
    /// Rows N, N_xi, N_eta, N_xixi, N_xieta, N_etaeta, ...: derivative (k, l)
    /// is row derivativeRow(k, l).
    Eigen::MatrixXd N;
};

/// Row of the k-th derivative by xi and l-th by eta.
constexpr int derivativeRow(int k, int l) {
    return (k + l) * (k + l + 1) / 2 + l;
}
/// Rows of all derivatives up to the total order n.
constexpr int nDerivativeRows(int n) {
    return (n + 1) * (n + 2) / 2;
}

struct BoundaryCurve {
    NurbsCurve curve;
    /// Number in the surface of each control point of the curve.
    std::vector<int> controlPoints;
};

/// Tensor-product surface in space; control point (i, j) has the number
/// i + nU * j, with i along xi. Rational if there are weights.
class NurbsSurface {
  public:
    /// @param controlPoints  (nU nV) x 3 [m]
    /// @param weights        nU nV, positive; empty means polynomial. Equal
    ///                       weights are dropped.
    /// @throws InputError if counts do not agree, a coordinate is not finite or
    /// a weight is not positive.
    NurbsSurface(KnotVector u, KnotVector v, Points controlPoints, Eigen::VectorXd weights = {});

    const KnotVector& u() const { return u_; }
    const KnotVector& v() const { return v_; }
    const Points& controlPoints() const { return controlPoints_; }
    /// Empty if the surface is polynomial.
    const Eigen::VectorXd& weights() const { return weights_; }
    bool isRational() const { return weights_.size() > 0; }
    int nControlPoints() const { return u_.nBasis() * v_.nBasis(); }

    Point point(double xi, double eta) const;

    /// @return nDerivativeRows(n) x 3, rows as in SurfaceBasis.
    Points derivatives(double xi, double eta, int n) const;

    /// Functions and their derivatives up to the total order nDerivatives.
    /// Source: Piegl & Tiller, The NURBS Book, equation 4.20 for each function
    SurfaceBasis basis(double xi, double eta, int nDerivatives) const;

    /// The edge as a curve; left and right run along eta, bottom and top along xi.
    BoundaryCurve boundaryCurve(Edge edge) const;

    /// Surface of the same functions with other control points (a deformed one).
    NurbsSurface withControlPoints(Points controlPoints) const;

  private:
    KnotVector u_, v_;
    Points controlPoints_;
    Eigen::VectorXd weights_;
};

/// Basis functions of given knot spans, as NurbsSurface::basis, whose polynomials
/// continue outside of the spans.
SurfaceBasis spanBasis(const NurbsSurface& surface, int spanU, int spanV, double xi, double eta,
                       int nDerivatives);

} // namespace tokay::geometry
