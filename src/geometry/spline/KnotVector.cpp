// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/KnotVector.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace tokay::geometry {

namespace {

void checkSequence(int degree, const std::vector<double>& knots) {
    if (degree < 1) {
        throw InputError(fmt::format("a knot vector needs a degree of at least 1, not {}", degree));
    }
    if (degree > KnotVector::maxDegree) {
        throw InputError(fmt::format("a knot vector of degree {} is beyond the limit of {}", degree,
                                     KnotVector::maxDegree));
    }
    const int nKnots = static_cast<int>(knots.size());
    if (nKnots < 2 * (degree + 1)) {
        throw InputError(fmt::format("a knot vector of degree {} needs at least {} knots, not {}",
                                     degree, 2 * (degree + 1), nKnots));
    }
    for (int i = 0; i < nKnots; ++i) {
        if (!std::isfinite(knots[i])) {
            throw InputError(
                fmt::format("knot {} of {} is {}: give a finite number", i, nKnots, knots[i]));
        }
        if (i > 0 && knots[i] < knots[i - 1]) {
            throw InputError(
                fmt::format("knot {} is {}, below the one before it, {}: knots must not "
                            "decrease",
                            i, knots[i], knots[i - 1]));
        }
    }
}

/// Spans must be resolved by double precision: what is computed in them is
/// divided by their lengths, and recursions halve them.
void checkSpans(const KnotVector& knots) {
    const std::vector<double>& at = knots.breakpoints();
    const double largest = std::max(std::abs(at.front()), std::abs(at.back()));
    constexpr double least = 1e-50, most = 1e50;
    if (!(largest < most)) {
        throw InputError(
            fmt::format("the knots reach from {} to {}: their magnitude must be below {:g}; scale "
                        "the parameters",
                        at.front(), at.back(), most));
    }
    for (std::size_t i = 1; i < at.size(); ++i) {
        const double span = at[i] - at[i - 1];
        if (!(span > std::max(least, 1e-14 * largest))) {
            throw InputError(fmt::format("the knot span from {} to {} is too short for double "
                                         "precision: make both the same knot, or scale and shift "
                                         "the parameters",
                                         at[i - 1], at[i]));
        }
    }
}

void checkMultiplicities(int degree, const KnotVector& knots) {
    for (const double knot : knots.breakpoints()) {
        const int multiplicity = knots.multiplicity(knot);
        const bool isEnd = knot == knots.first() || knot == knots.last();
        if (isEnd && multiplicity != degree + 1) {
            throw InputError(fmt::format("the end knot {} occurs {} times: an open knot vector of "
                                         "degree {} needs it {} times",
                                         knot, multiplicity, degree, degree + 1));
        }
        if (!isEnd && multiplicity > degree) {
            throw InputError(
                fmt::format("the inner knot {} occurs {} times: at most {} (the degree) "
                            "keep the curve continuous",
                            knot, multiplicity, degree));
        }
    }
}

/// Matrices on the stack: evaluations are many and short.
using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                            KnotVector::maxDegree + 1, KnotVector::maxDegree + 1>;
using Row = std::array<double, KnotVector::maxDegree + 1>;

/// Upper triangle and diagonal: basis functions of degree 0 to p; below it the
/// knot differences that the derivatives divide by.
Table functionTable(const std::vector<double>& knots, int p, int span, double xi) {
    Table table(p + 1, p + 1);
    Row left, right;
    table(0, 0) = 1;
    for (int j = 1; j <= p; ++j) {
        left[j] = xi - knots[span + 1 - j];
        right[j] = knots[span + j] - xi;
        double saved = 0;
        for (int r = 0; r < j; ++r) {
            table(j, r) = right[r + 1] + left[j - r];
            const double ratio = table(r, j - 1) / table(j, r);
            table(r, j) = saved + right[r + 1] * ratio;
            saved = left[j - r] * ratio;
        }
        table(j, j) = saved;
    }
    return table;
}

/// Column r of the derivatives, rows 1 to n, without the factor p! / (p - k)!.
void fillDerivatives(const Table& table, int r, int n, Eigen::MatrixXd& ders) {
    const int p = static_cast<int>(table.rows()) - 1;
    Table a = Table::Zero(2, p + 1);
    a(0, 0) = 1;
    int previous = 0;
    for (int k = 1; k <= n; ++k) {
        const int current = 1 - previous;
        const int rk = r - k, pk = p - k;
        double sum = 0;
        if (r >= k) {
            a(current, 0) = a(previous, 0) / table(pk + 1, rk);
            sum = a(current, 0) * table(rk, pk);
        }
        const int begin = rk >= -1 ? 1 : -rk;
        const int end = r - 1 <= pk ? k - 1 : p - r;
        for (int j = begin; j <= end; ++j) {
            a(current, j) = (a(previous, j) - a(previous, j - 1)) / table(pk + 1, rk + j);
            sum += a(current, j) * table(rk + j, pk);
        }
        if (r <= pk) {
            a(current, k) = -a(previous, k - 1) / table(pk + 1, r);
            sum += a(current, k) * table(r, pk);
        }
        ders(k, r) = sum;
        previous = current;
    }
}

} // namespace

KnotVector::KnotVector(int degree, std::vector<double> knots)
    : degree_(degree), knots_(std::move(knots)) {
    checkSequence(degree_, knots_);
    std::unique_copy(knots_.begin(), knots_.end(), std::back_inserter(breakpoints_));
    checkSpans(*this);
    checkMultiplicities(degree_, *this);
}

KnotVector KnotVector::uniform(int degree, int nSpans, double first, double last) {
    if (nSpans < 1) {
        throw InputError(fmt::format("a knot vector needs at least 1 span, not {}", nSpans));
    }
    if (!(first < last)) {
        throw InputError(fmt::format("a knot vector from {} to {} has no length", first, last));
    }
    std::vector<double> knots(degree + 1, first);
    for (int i = 1; i < nSpans; ++i) {
        knots.push_back(first + (last - first) * i / nSpans);
    }
    knots.insert(knots.end(), degree + 1, last);
    return KnotVector(degree, std::move(knots));
}

int KnotVector::multiplicity(double knot) const {
    const auto range = std::equal_range(knots_.begin(), knots_.end(), knot);
    return static_cast<int>(range.second - range.first);
}

int KnotVector::findSpan(double xi) const {
    // Searched among the inner knots only: so the ends get a span that is not empty.
    const auto begin = knots_.begin() + degree_ + 1, end = knots_.end() - degree_ - 1;
    return static_cast<int>(std::upper_bound(begin, end, xi) - knots_.begin()) - 1;
}

Eigen::MatrixXd KnotVector::basisDerivatives(int span, double xi, int nDerivatives) const {
    assert(span >= degree_ && span < nBasis() && knots_[span] < knots_[span + 1]);
    const int p = degree_;
    const Table table = functionTable(knots_, p, span, xi);
    Eigen::MatrixXd ders = Eigen::MatrixXd::Zero(nDerivatives + 1, p + 1);
    ders.row(0) = table.col(p);
    const int n = std::min(nDerivatives, p); // higher ones vanish
    if (n == 0) {
        return ders;
    }
    for (int r = 0; r <= p; ++r) {
        fillDerivatives(table, r, n, ders);
    }
    double factor = 1;
    for (int k = 1; k <= n; ++k) {
        factor *= p - k + 1;
        ders.row(k) *= factor;
    }
    return ders;
}

void KnotVector::valuesAndSlopes(int span, double xi, Eigen::Matrix2Xd& N) const {
    assert(N.cols() == degree_ + 1);
    const int p = degree_;
    N(0, 0) = 1;
    for (int j = 1; j <= p; ++j) {
        if (j == p) {
            N.row(1).head(p) = N.row(0).head(p);
        }
        double saved = 0;
        for (int r = 0; r < j; ++r) {
            const double above = knots_[span + r + 1], below = knots_[span + 1 - j + r];
            const double ratio = N(0, r) / (above - below);
            N(0, r) = saved + (above - xi) * ratio;
            saved = (xi - below) * ratio;
        }
        N(0, j) = saved;
    }
    // Differences of the functions of degree p - 1, over their knots.
    double previous = 0;
    for (int r = 0; r < p; ++r) {
        const double ratio = p * N(1, r) / (knots_[span + r + 1] - knots_[span + r + 1 - p]);
        N(1, r) = previous - ratio;
        previous = ratio;
    }
    N(1, p) = previous;
}

std::vector<double> KnotVector::grevilleAbscissae() const {
    std::vector<double> abscissae(nBasis());
    for (int i = 0; i < nBasis(); ++i) {
        double sum = 0;
        for (int j = 1; j <= degree_; ++j) {
            sum += knots_[i + j];
        }
        // Rounding of the mean must not leave the range.
        abscissae[i] = std::clamp(sum / degree_, first(), last());
    }
    return abscissae;
}

} // namespace tokay::geometry
