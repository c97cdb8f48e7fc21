// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

#include <array>

namespace tokay::structure {

/// Taylor polynomial of a function of (xi, eta) up to the total degree 4, with the
/// arithmetic of such functions: derivatives of what is made of a surface's position come
/// out without a formula for each.
/// Source: Griewank & Walther 2008, chapter 13 (propagation of Taylor coefficients)
class TaylorPolynomial {
  public:
    static constexpr int degree = 4;
    static constexpr int nCoefficients = geometry::nDerivativeRows(degree);

    TaylorPolynomial(double constant = 0) : c_{} { c_[0] = constant; }

    /// @param derivatives  of the function at a point, in the order of
    ///                     geometry::derivativeRow
    template <class Derivatives>
    static TaylorPolynomial of(const Derivatives& derivatives);

    double value() const { return c_[0]; }
    bool isZero() const;

    TaylorPolynomial& operator+=(const TaylorPolynomial& other);
    TaylorPolynomial& operator-=(const TaylorPolynomial& other);
    TaylorPolynomial operator*(const TaylorPolynomial& other) const;
    /// The derivative by xi (axis 0) or eta (1). What the highest terms become is lost: each
    /// derivative costs a degree of accuracy.
    TaylorPolynomial derivative(int axis) const;

    /// @throws nothing; the value must be positive
    TaylorPolynomial power(double exponent) const;

  private:
    std::array<double, nCoefficients> c_; ///< of xi^k eta^l, at derivativeRow(k, l)
};

template <class Derivatives>
TaylorPolynomial TaylorPolynomial::of(const Derivatives& derivatives) {
    constexpr double factorial[] = {1, 1, 2, 6, 24};
    TaylorPolynomial polynomial;
    for (int n = 0; n <= degree; ++n) {
        for (int l = 0; l <= n; ++l) {
            const int row = geometry::derivativeRow(n - l, l);
            polynomial.c_[row] = derivatives[row] / (factorial[n - l] * factorial[l]);
        }
    }
    return polynomial;
}

inline TaylorPolynomial operator+(TaylorPolynomial a, const TaylorPolynomial& b) {
    return a += b;
}
inline TaylorPolynomial operator-(TaylorPolynomial a, const TaylorPolynomial& b) {
    return a -= b;
}

/// A vector of space that depends on (xi, eta).
using TaylorVector = std::array<TaylorPolynomial, 3>;

TaylorPolynomial dot(const TaylorVector& a, const TaylorVector& b);
TaylorVector cross(const TaylorVector& a, const TaylorVector& b);
TaylorVector operator*(const TaylorPolynomial& factor, const TaylorVector& vector);

} // namespace tokay::structure
