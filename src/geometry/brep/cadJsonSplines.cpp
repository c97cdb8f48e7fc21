// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJsonSplines.hpp"

#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/openSpline.hpp"
#include "geometry/spline/rational.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tokay::geometry {

namespace {

/// Rows (x, y, z, w) of points [id, [x, y, z, w]] or [[x, y, z, w]].
Eigen::MatrixXd readControlPoints(const LocatedNode& owner) {
    const LocatedNode node = owner.required("control_points");
    const bool mayBeRational = !owner.has("is_rational") || owner.required("is_rational").boolean();
    const std::vector<LocatedNode> items = node.items();
    Eigen::MatrixXd rows(items.size(), 4);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::vector<LocatedNode> parts = items[i].items();
        if (parts.empty() || parts.size() > 2) {
            throw items[i].error("a control point is given as [number, [x, y, z, weight]]");
        }
        const std::vector<double> values = parts.back().numbers(4);
        if (!(values[3] > 0)) {
            throw parts.back().error(
                fmt::format("the weight is {}, but must be positive", values[3]));
        }
        rows.row(i) = Eigen::RowVector4d::Map(values.data());
        if (!mayBeRational && values[3] != rows(0, 3)) {
            throw parts.back().error(
                fmt::format("the weight is {}, the first one {}, but \"is_rational\" is "
                            "false: correct one of them",
                            values[3], rows(0, 3)));
        }
    }
    return rows;
}

Eigen::MatrixXd homogeneousRows(const Eigen::MatrixXd& rows) {
    Eigen::MatrixXd result = rows;
    result.leftCols(3) = rows.col(3).asDiagonal() * rows.leftCols(3);
    return result;
}

/// Points and weights of homogeneous rows; as they were given to the bit if
/// those are still the same.
std::pair<Points, Eigen::VectorXd> pointsAndWeights(const Eigen::MatrixXd& rows,
                                                    const Eigen::MatrixXd& given) {
    const bool isSame = rows.rows() == given.rows() && rows == homogeneousRows(given);
    if (isSame) {
        return {given.leftCols(3), given.col(3)};
    }
    return dehomogenised(rows);
}

/// Opens the knot vector of a net's direction whose index runs fastest, and
/// turns the net, so that a second call does the other direction.
SplineCoefficients openDirection(int degree, const std::vector<double>& knots,
                                 const Eigen::MatrixXd& net, Eigen::Index n) {
    const Eigen::Index other = net.rows() / n;
    Eigen::MatrixXd lines(n, 4 * other);
    for (Eigen::Index j = 0; j < other; ++j) {
        for (Eigen::Index i = 0; i < n; ++i) {
            lines.block<1, 4>(i, 4 * j) = net.row(i + n * j);
        }
    }
    SplineCoefficients opened = openSpline(degree, knots, lines);
    Eigen::MatrixXd turned(opened.rows.rows() * other, 4);
    for (Eigen::Index i = 0; i < opened.rows.rows(); ++i) {
        for (Eigen::Index j = 0; j < other; ++j) {
            turned.row(j + other * i) = opened.rows.block<1, 4>(i, 4 * j);
        }
    }
    return {std::move(opened.knots), std::move(turned)};
}

/// Number of control points in a direction, from its knots: n + degree + 1 or
/// n + degree - 1 of them, whichever fits the other direction and the total.
std::array<Eigen::Index, 2> netSize(const LocatedNode& surface, const std::vector<int>& degrees,
                                    const std::array<std::vector<double>, 2>& knots,
                                    Eigen::Index total) {
    for (const int more : {1, -1}) {
        const auto nU = static_cast<Eigen::Index>(knots[0].size()) - degrees[0] - more;
        const auto nV = static_cast<Eigen::Index>(knots[1].size()) - degrees[1] - more;
        if (nU > 0 && nV > 0 && nU * nV == total) {
            return {nU, nV};
        }
    }
    throw surface.error(
        fmt::format("there are {} control points, but degrees {} and {} with {} "
                    "and {} knots need {}",
                    total, degrees[0], degrees[1], knots[0].size(), knots[1].size(),
                    (knots[0].size() - degrees[0] - 1) * (knots[1].size() - degrees[1] - 1)));
}

} // namespace

NurbsCurve readCurve(const LocatedNode& node) {
    const int degree = node.required("degree").integer();
    const LocatedNode knots = node.required("knot_vector");
    const Eigen::MatrixXd rows = readControlPoints(node);
    const NurbsCurve curve = knots.make([&] {
        const SplineCoefficients spline =
            openSpline(degree, knots.numbers(), homogeneousRows(rows));
        auto [points, weights] = pointsAndWeights(spline.rows, rows);
        return NurbsCurve(spline.knots, std::move(points), std::move(weights));
    });
    if (!node.has("active_range")) {
        return curve;
    }
    const LocatedNode active = node.required("active_range");
    std::vector<double> range = active.numbers(2);
    const double first = curve.knotVector().first(), last = curve.knotVector().last();
    for (double& end : range) {
        const double inside = std::clamp(end, first, last);
        constexpr double rounding = 1e-6; // gaps that this leaves are the loops' to close
        end = std::abs(end - inside) <= rounding * (last - first) ? inside : end;
    }
    if (range[0] == first && range[1] == last) {
        return curve;
    }
    return active.make([&] { return partOf(curve, range[0], range[1]); });
}

NurbsSurface readSurface(const LocatedNode& node) {
    std::vector<int> degrees;
    for (const LocatedNode& degree : node.required("degrees").items()) {
        degrees.push_back(degree.integer());
    }
    const LocatedNode knotVectors = node.required("knot_vectors");
    const std::vector<LocatedNode> both = knotVectors.items();
    if (degrees.size() != 2) {
        throw node.required("degrees").error("a surface has two degrees");
    }
    if (both.size() != 2) {
        throw knotVectors.error("a surface has two knot vectors");
    }
    const std::array<std::vector<double>, 2> knots = {both[0].numbers(), both[1].numbers()};
    const Eigen::MatrixXd given = readControlPoints(node), net = homogeneousRows(given);
    const auto [nU, nV] = netSize(node, degrees, knots, net.rows());
    const SplineCoefficients u =
        both[0].make([&, n = nU] { return openDirection(degrees[0], knots[0], net, n); });
    const SplineCoefficients v =
        both[1].make([&, n = nV] { return openDirection(degrees[1], knots[1], u.rows, n); });
    return node.make([&] {
        auto [points, weights] = pointsAndWeights(v.rows, given);
        return NurbsSurface(u.knots, v.knots, std::move(points), std::move(weights));
    });
}

} // namespace tokay::geometry
