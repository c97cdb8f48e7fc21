// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tokay::geometry {

/// Open knot vector with its B-spline basis.
///
/// Terminology: a *knot* is an entry of the non-decreasing sequence; equal
/// knots count by their *multiplicity*; a *breakpoint* is a distinct knot; a
/// *knot span* i is the interval [knot i, knot i+1); *open* means that the first
/// and last knot have multiplicity degree + 1. Function i lives on knots i to
/// i + degree + 1; on span i the functions i - degree to i are not zero.
class KnotVector {
  public:
    /// CAD systems write up to 24 (Parasolid, ACIS).
    static constexpr int maxDegree = 24;

    /// @throws InputError if the degree is not 1 to maxDegree, if a knot is not finite or
    /// smaller than the one before it, if an end is not open, or if an inner
    /// knot is repeated more than degree times.
    KnotVector(int degree, std::vector<double> knots);

    /// nSpans spans of equal length over [first, last].
    static KnotVector uniform(int degree, int nSpans, double first = 0, double last = 1);

    int degree() const { return degree_; }
    int nBasis() const { return static_cast<int>(knots_.size()) - degree_ - 1; }
    const std::vector<double>& knots() const { return knots_; }
    double first() const { return knots_.front(); }
    double last() const { return knots_.back(); }

    /// Distinct knots, ascending.
    const std::vector<double>& breakpoints() const { return breakpoints_; }
    int nSpans() const { return static_cast<int>(breakpoints_.size()) - 1; }

    /// Multiplicity of a knot; 0 if it is none.
    int multiplicity(double knot) const;

    /// The span i, not empty, with knot i <= xi < knot i+1. The last span also
    /// contains its end; a xi outside the range gets the first or the last span.
    int findSpan(double xi) const;

    /// Values and derivatives of the degree + 1 functions of a span.
    /// @return (nDerivatives + 1) x (degree + 1); row k is the k-th derivative,
    /// column j is function span - degree + j. Outside the span the polynomials
    /// of the span go on.
    /// Source: Piegl & Tiller, The NURBS Book, algorithm A2.3
    Eigen::MatrixXd basisDerivatives(int span, double xi, int nDerivatives) const;

    /// Basis functions and first derivatives, written into memory of the caller.
    /// @param N  2 x (degree + 1)
    void valuesAndSlopes(int span, double xi, Eigen::Matrix2Xd& N) const;

    /// Greville parameter of each function: the mean of its degree inner knots.
    std::vector<double> grevilleAbscissae() const;

  private:
    int degree_;
    std::vector<double> knots_;
    std::vector<double> breakpoints_;
};

} // namespace tokay::geometry
