// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/TaylorPolynomial.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tokay::structure {

using geometry::derivativeRow;

bool TaylorPolynomial::isZero() const {
    return std::all_of(c_.begin(), c_.end(), [](double c) { return c == 0; });
}

TaylorPolynomial& TaylorPolynomial::operator+=(const TaylorPolynomial& other) {
    for (int k = 0; k < nCoefficients; ++k) {
        c_[k] += other.c_[k];
    }
    return *this;
}

TaylorPolynomial& TaylorPolynomial::operator-=(const TaylorPolynomial& other) {
    for (int k = 0; k < nCoefficients; ++k) {
        c_[k] -= other.c_[k];
    }
    return *this;
}

namespace {

// Calls visit(n, l) for all terms xi^(n - l) eta^l up to a total degree.
template <class Visit>
void forEachTerm(int degree, Visit visit) {
    for (int n = 0; n <= degree; ++n) {
        for (int l = 0; l <= n; ++l) {
            visit(n, l);
        }
    }
}

} // namespace

TaylorPolynomial TaylorPolynomial::operator*(const TaylorPolynomial& other) const {
    TaylorPolynomial product;
    forEachTerm(degree, [&](int n, int l) {
        const double factor = c_[derivativeRow(n - l, l)];
        if (factor == 0) {
            return;
        }
        forEachTerm(degree - n, [&](int m, int k) {
            product.c_[derivativeRow(n - l + m - k, l + k)] +=
                factor * other.c_[derivativeRow(m - k, k)];
        });
    });
    return product;
}

TaylorPolynomial TaylorPolynomial::derivative(int axis) const {
    TaylorPolynomial result;
    forEachTerm(degree - 1, [&](int n, int l) {
        const int k = n - l;
        result.c_[derivativeRow(k, l)] = axis == 0 ? (k + 1) * c_[derivativeRow(k + 1, l)]
                                                   : (l + 1) * c_[derivativeRow(k, l + 1)];
    });
    return result;
}

// a^e (1 + x)^e by the binomial series, in Horner's order; x has no constant term.
TaylorPolynomial TaylorPolynomial::power(double exponent) const {
    assert(c_[0] > 0);
    TaylorPolynomial x = *this;
    for (double& c : x.c_) {
        c /= c_[0];
    }
    x.c_[0] = 0;
    TaylorPolynomial sum(1);
    for (int k = degree; k >= 1; --k) {
        sum = TaylorPolynomial(1) + TaylorPolynomial((exponent - k + 1) / k) * (x * sum);
    }
    return TaylorPolynomial(std::pow(c_[0], exponent)) * sum;
}

TaylorPolynomial dot(const TaylorVector& a, const TaylorVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

TaylorVector cross(const TaylorVector& a, const TaylorVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

TaylorVector operator*(const TaylorPolynomial& factor, const TaylorVector& vector) {
    return {factor * vector[0], factor * vector[1], factor * vector[2]};
}

} // namespace tokay::structure
