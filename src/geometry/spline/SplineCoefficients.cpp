// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/SplineCoefficients.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

/// Weights of the rows span - degree to span in the blossom of the span's
/// polynomial at the given degree arguments. A coefficient of any refined
/// spline is the blossom at the inner knots of its function.
/// Source: Ramshaw, Blossoms are polar forms, 1989; the recursion is that of
/// the basis functions with another argument at each level.
Eigen::RowVectorXd blossomWeights(const KnotVector& knots, int span,
                                  const std::vector<double>& arguments) {
    const std::vector<double>& t = knots.knots();
    Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(knots.degree() + 1);
    weights[0] = 1;
    for (int level = 1; level <= knots.degree(); ++level) {
        const double x = arguments[level - 1];
        double saved = 0;
        for (int r = 0; r < level; ++r) {
            const double right = t[span + r + 1], left = t[span + 1 - level + r];
            const double ratio = weights[r] / (right - left);
            weights[r] = saved + (right - x) * ratio;
            saved = (x - left) * ratio;
        }
        weights[level] = saved;
    }
    return weights;
}

Eigen::RowVectorXd blossom(const SplineCoefficients& spline, int span,
                           const std::vector<double>& arguments) {
    const int p = spline.knots.degree();
    return blossomWeights(spline.knots, span, arguments) * spline.rows.middleRows(span - p, p + 1);
}

/// The inner knots of function i: the arguments of its coefficient.
std::vector<double> innerKnots(const KnotVector& knots, int i) {
    return {knots.knots().begin() + i + 1, knots.knots().begin() + i + 1 + knots.degree()};
}

/// A span of the old knots inside the support of the new function i, as central
/// as can be so that the blossom extrapolates little.
int centralSpan(const KnotVector& old, const KnotVector& fine, int i) {
    const double lower = fine.knots()[i], upper = fine.knots()[i + fine.degree() + 1];
    return old.findSpan(0.5 * (lower + upper));
}

KnotVector withKnots(const KnotVector& knots, const std::vector<double>& added) {
    for (const double knot : added) {
        if (!(knot > knots.first() && knot < knots.last())) {
            throw InputError(
                fmt::format("the knot {} cannot be inserted: it must lie inside ({}, {})", knot,
                            knots.first(), knots.last()));
        }
    }
    if (!std::is_sorted(added.begin(), added.end())) {
        throw InputError("knots to insert must be ascending");
    }
    std::vector<double> merged(knots.knots().size() + added.size());
    std::merge(knots.knots().begin(), knots.knots().end(), added.begin(), added.end(),
               merged.begin());
    return KnotVector(knots.degree(), std::move(merged));
}

KnotVector withoutKnots(const KnotVector& knots, const std::vector<double>& removed) {
    std::vector<double> left;
    auto next = removed.begin();
    for (const double knot : knots.knots()) {
        if (next != removed.end() && *next == knot && knot > knots.first() && knot < knots.last()) {
            ++next;
        } else {
            left.push_back(knot);
        }
    }
    if (next != removed.end()) {
        throw InputError(fmt::format("the knot {} cannot be removed: it is not inside ({}, {}), "
                                     "not there so often, or the knots to remove do not ascend",
                                     *next, knots.first(), knots.last()));
    }
    return KnotVector(knots.degree(), std::move(left));
}

/// Largest distance of two rows.
double extent(const Eigen::MatrixXd& rows) {
    return (rows.colwise().maxCoeff() - rows.colwise().minCoeff()).norm();
}

KnotVector elevated(const KnotVector& knots) {
    std::vector<double> fine;
    for (const double knot : knots.breakpoints()) {
        fine.insert(fine.end(), knots.multiplicity(knot) + 1, knot);
    }
    return KnotVector(knots.degree() + 1, std::move(fine));
}

} // namespace

SplineCoefficients insertKnots(const SplineCoefficients& spline, const std::vector<double>& knots) {
    SplineCoefficients fine{withKnots(spline.knots, knots), {}};
    fine.rows.resize(fine.knots.nBasis(), spline.rows.cols());
    for (int i = 0; i < fine.knots.nBasis(); ++i) {
        fine.rows.row(i) =
            blossom(spline, centralSpan(spline.knots, fine.knots, i), innerKnots(fine.knots, i));
    }
    return fine;
}

SplineCoefficients removeKnots(const SplineCoefficients& spline, const std::vector<double>& knots,
                               double tolerance) {
    SplineCoefficients coarse{withoutKnots(spline.knots, knots), {}};
    coarse.rows.resize(coarse.knots.nBasis(), spline.rows.cols());
    // A spline of the coarser space is one polynomial over what was two spans: any
    // span inside a coarse function's support tells its coefficient.
    for (int i = 0; i < coarse.knots.nBasis(); ++i) {
        coarse.rows.row(i) = blossom(spline, centralSpan(spline.knots, coarse.knots, i),
                                     innerKnots(coarse.knots, i));
    }
    const double off = (insertKnots(coarse, knots).rows - spline.rows).rowwise().norm().maxCoeff();
    if (off > tolerance * extent(spline.rows)) {
        throw InputError(fmt::format("the knots cannot be removed: the spline is not smooth "
                                     "enough there, its coefficients would be off by {:.2g} of "
                                     "their extent (tolerance {:g})",
                                     off / extent(spline.rows), tolerance));
    }
    return coarse;
}

SplineCoefficients elevateDegree(const SplineCoefficients& spline) {
    SplineCoefficients fine{elevated(spline.knots), {}};
    fine.rows = Eigen::MatrixXd::Zero(fine.knots.nBasis(), spline.rows.cols());
    const int degree = fine.knots.degree();
    for (int i = 0; i < fine.knots.nBasis(); ++i) {
        const int span = centralSpan(spline.knots, fine.knots, i);
        const std::vector<double> arguments = innerKnots(fine.knots, i);
        // The blossom of higher degree is the mean over leaving out one argument.
        for (int k = 0; k < degree; ++k) {
            std::vector<double> others = arguments;
            others.erase(others.begin() + k);
            fine.rows.row(i) += blossom(spline, span, others) / degree;
        }
    }
    return fine;
}

} // namespace tokay::geometry
