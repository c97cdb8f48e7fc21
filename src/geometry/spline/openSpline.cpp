// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/openSpline.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

struct RawSpline {
    std::vector<double> knots;
    Eigen::MatrixXd rows;
};

/// Inserts one knot into any knot vector.
/// Source: Boehm, Comput. Aided Des. 12, 1980
void insertKnot(int degree, double knot, RawSpline& spline) {
    const auto after = std::upper_bound(spline.knots.begin(), spline.knots.end(), knot);
    const int span = static_cast<int>(after - spline.knots.begin()) - 1;
    const Eigen::Index n = spline.rows.rows();
    Eigen::MatrixXd rows(n + 1, spline.rows.cols());
    for (Eigen::Index i = 0; i <= n; ++i) {
        double share = i <= span - degree ? 1 : 0;
        if (i > span - degree && i <= span) {
            share = (knot - spline.knots[i]) / (spline.knots[i + degree] - spline.knots[i]);
        }
        rows.row(i).setZero();
        if (share != 0) {
            rows.row(i) += share * spline.rows.row(i);
        }
        if (share != 1) {
            rows.row(i) += (1 - share) * spline.rows.row(i - 1);
        }
    }
    spline.rows = std::move(rows);
    spline.knots.insert(spline.knots.begin() + span + 1, knot);
}

int multiplicity(const std::vector<double>& knots, double knot) {
    return static_cast<int>(std::count(knots.begin(), knots.end(), knot));
}

/// Drops what lies before the start of the range.
void cutStart(int degree, RawSpline& spline) {
    const double start = spline.knots[degree];
    while (multiplicity(spline.knots, start) < degree) {
        insertKnot(degree, start, spline);
    }
    const auto after = std::upper_bound(spline.knots.begin(), spline.knots.end(), start);
    const Eigen::Index dropped = after - spline.knots.begin() - degree - 1;
    spline.rows =
        spline.rows.bottomRows(spline.rows.rows() - std::max<Eigen::Index>(dropped, 0)).eval();
    std::vector<double> knots(degree + 1, start);
    knots.insert(knots.end(), after, spline.knots.end());
    spline.knots = std::move(knots);
}

RawSpline turned(const RawSpline& spline) {
    RawSpline result{{}, spline.rows.colwise().reverse()};
    for (auto knot = spline.knots.rbegin(); knot != spline.knots.rend(); ++knot) {
        result.knots.push_back(-*knot);
    }
    return result;
}

} // namespace

SplineCoefficients openSpline(int degree, std::vector<double> knots, Eigen::MatrixXd rows) {
    const auto n = static_cast<std::size_t>(rows.rows()), p = static_cast<std::size_t>(degree);
    if (degree < 1) {
        throw InputError(fmt::format("the degree is {}: it must be at least 1", degree));
    }
    if (n > p && knots.size() == n + p - 1) {
        knots.insert(knots.begin(), knots.front());
        knots.push_back(knots.back());
    }
    if (n <= p || knots.size() != n + p + 1) {
        throw InputError(fmt::format("there are {} knots for {} control points of degree {}: {} "
                                     "are needed (or {} without the first and the last)",
                                     knots.size(), n, degree, n + p + 1, n + p - 1));
    }
    for (std::size_t i = 1; i < knots.size(); ++i) {
        if (!(knots[i] >= knots[i - 1])) {
            throw InputError(fmt::format("knot {} is {}, less than the one before it, {}", i,
                                         knots[i], knots[i - 1]));
        }
    }
    if (!(knots[p] < knots[n])) {
        throw InputError(fmt::format("the knots span no range: knot {} and knot {} are both {}", p,
                                     n, knots[p]));
    }
    RawSpline spline{std::move(knots), std::move(rows)};
    cutStart(degree, spline);
    spline = turned(spline);
    cutStart(degree, spline);
    spline = turned(spline);
    return {KnotVector(degree, std::move(spline.knots)), std::move(spline.rows)};
}

} // namespace tokay::geometry
