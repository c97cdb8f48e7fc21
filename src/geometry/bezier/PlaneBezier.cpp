// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/PlaneBezier.hpp"

#include "common/errors.hpp"
#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/bezier/parameterCrossings.hpp"
#include "geometry/spline/rational.hpp"

#include <fmt/format.h>

namespace tokay::geometry {

namespace {

using Controls = PlaneBezier::Controls;

Controls homogeneousControls(const NurbsCurve& piece) {
    Controls controls(3, piece.nControlPoints());
    for (int i = 0; i < piece.nControlPoints(); ++i) {
        const double weight = piece.isRational() ? piece.weights()[i] : 1;
        controls.col(i) << weight * piece.controlPoints().row(i).head<2>().transpose(), weight;
    }
    return controls;
}

/// One step of de Casteljau's algorithm on the first n + 1 columns.
void contract(Controls& c, int n, double t) {
    for (int i = 0; i < n; ++i) {
        c.col(i) += t * (c.col(i + 1) - c.col(i));
    }
}

/// Bernstein coefficients of a product.
Eigen::VectorXd product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    const int m = static_cast<int>(a.size()) - 1, n = static_cast<int>(b.size()) - 1;
    Eigen::VectorXd c = Eigen::VectorXd::Zero(m + n + 1);
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            c[i + j] += binomial(m, i) * binomial(n, j) / binomial(m + n, i + j) * a[i] * b[j];
        }
    }
    return c;
}

/// Bernstein coefficients of the derivative.
Eigen::VectorXd derivative(const Eigen::VectorXd& a) {
    const Eigen::Index n = a.size() - 1;
    return static_cast<double>(n) * (a.tail(n) - a.head(n));
}

double flatness(const PlaneBezier& piece, const Parameters& tolerance) {
    const Parameters chord = piece.end() - piece.start();
    const Parameters unit = tolerance.cwiseInverse();
    const Parameters along = chord.cwiseProduct(unit).normalized();
    double worst = 0;
    for (int i = 1; i < piece.degree(); ++i) {
        const Parameters arm = (piece.controlPoint(i) - piece.start()).cwiseProduct(unit);
        worst = std::max(worst, (arm - arm.dot(along) * along).norm());
    }
    return worst;
}

void appendChords(const PlaneBezier& piece, const Parameters& tolerance, int depth,
                  std::vector<Parameters>& points) {
    constexpr int deepest = 20;
    if (depth == deepest || flatness(piece, tolerance) <= 1) {
        points.push_back(piece.start());
        return;
    }
    for (const PlaneBezier& half : piece.split(0.5)) {
        appendChords(half, tolerance, depth + 1, points);
    }
}

} // namespace

PlaneBezier::PlaneBezier(Controls controls)
    : controls_(std::move(controls)), start_(controlPoint(0)), end_(controlPoint(degree())) {}

std::vector<PlaneBezier> PlaneBezier::piecesOf(const NurbsCurve& curve) {
    if (curve.degree() > maxDegree) {
        throw InputError(fmt::format("a trimming curve has degree {}; at most {} is possible",
                                     curve.degree(), maxDegree));
    }
    std::vector<PlaneBezier> pieces;
    for (const NurbsCurve& piece : bezierPieces(curve)) {
        pieces.emplace_back(homogeneousControls(piece));
    }
    return pieces;
}

Parameters PlaneBezier::point(double t) const {
    Controls c = controls_;
    for (int n = degree(); n > 0; --n) {
        contract(c, n, t);
    }
    return c.col(0).head<2>() / c(2, 0);
}

PlaneBezier::Tangent PlaneBezier::tangent(double t) const {
    Controls c = controls_;
    for (int n = degree(); n > 1; --n) {
        contract(c, n, t);
    }
    const Eigen::Vector3d slope = degree() * (c.col(1) - c.col(0));
    contract(c, 1, t);
    const Parameters point = c.col(0).head<2>() / c(2, 0);
    return {point, (slope.head<2>() - slope[2] * point) / c(2, 0)};
}

std::array<PlaneBezier, 2> PlaneBezier::split(double t) const {
    Controls left(3, degree() + 1), right = controls_;
    for (int n = degree(); n >= 0; --n) {
        left.col(degree() - n) = right.col(0);
        contract(right, n, t);
    }
    std::array<PlaneBezier, 2> halves = {PlaneBezier(std::move(left)),
                                         PlaneBezier(std::move(right))};
    halves[0].start_ = start_;
    halves[1].start_ = halves[0].end_;
    halves[1].end_ = end_;
    return halves;
}

PlaneBezier PlaneBezier::withEnds(const Parameters& start, const Parameters& end) const {
    PlaneBezier moved = *this;
    const Eigen::Index last = controls_.cols() - 1;
    moved.controls_.col(0).head<2>() = controls_(2, 0) * start;
    moved.controls_.col(last).head<2>() = controls_(2, last) * end;
    moved.start_ = start;
    moved.end_ = end;
    return moved;
}

PlaneBezier PlaneBezier::reversed() const {
    PlaneBezier result = *this;
    result.controls_ = controls_.rowwise().reverse();
    std::swap(result.start_, result.end_);
    return result;
}

PlaneBezier PlaneBezier::scaled(const Parameters& origin, const Parameters& scale) const {
    PlaneBezier result = *this;
    const auto map = [&](const Parameters& point) {
        return Parameters((point - origin).cwiseProduct(scale));
    };
    for (int i = 0; i <= degree(); ++i) {
        result.controls_.col(i).head<2>() = controls_(2, i) * map(controlPoint(i));
    }
    result.start_ = map(start_);
    result.end_ = map(end_);
    return result;
}

ParameterBox PlaneBezier::box() const {
    ParameterBox box{start(), start()};
    for (int i = 1; i <= degree(); ++i) {
        box.lower = box.lower.cwiseMin(controlPoint(i));
        box.upper = box.upper.cwiseMax(controlPoint(i));
    }
    return box;
}

std::vector<double> PlaneBezier::extrema(int axis) const {
    if (degree() == 1) {
        return {};
    }
    // Roots of X' W - X W', the numerator of the derivative of X / W. Seen from
    // the middle of the curve fewer digits cancel.
    const double middle = point(0.5)[axis];
    const Eigen::VectorXd W = controls_.row(2).transpose();
    const Eigen::VectorXd X = controls_.row(axis).transpose() - middle * W;
    if (X.cwiseAbs().maxCoeff() <= 1e-15 * std::abs(middle) * W.maxCoeff()) {
        return {}; // constant but for rounding
    }
    return bernsteinRoots(product(derivative(X), W) - product(X, derivative(W)));
}

double PlaneBezier::parameterAt(int axis, double value) const {
    const double first = start()[axis], last = end()[axis];
    const double sign = last >= first ? 1 : -1;
    if (sign * (value - first) <= 0) {
        return 0;
    }
    if (sign * (value - last) >= 0) {
        return 1;
    }
    if (degree() == 1 && controls_(2, 0) == controls_(2, 1)) {
        return (value - first) / (last - first);
    }
    // Newton's iteration, or halving where it leaves the bracket.
    double from = 0, to = 1, t = (value - first) / (last - first);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const Tangent at = tangent(t);
        const double miss = sign * (at.point[axis] - value);
        (miss > 0 ? to : from) = t;
        double next = t - miss / (sign * at.derivative[axis]);
        if (!(next > from && next < to)) {
            next = 0.5 * (from + to);
        }
        if (miss == 0 || std::abs(next - t) <= 1e-16 || next == t) {
            return t;
        }
        t = next;
    }
    return t;
}

void PlaneBezier::appendChords(const Parameters& tolerance, std::vector<Parameters>& points) const {
    geometry::appendChords(*this, tolerance, 0, points);
}

} // namespace tokay::geometry
