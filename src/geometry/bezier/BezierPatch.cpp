// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bezier/BezierPatch.hpp"

#include <array>

namespace tokay::geometry {

namespace {

using Row = std::array<double, KnotVector::maxDegree + 1>;

/// Bernstein polynomials of one degree and their first two derivatives.
struct Bernstein {
    Row values, first, second;
};

/// Raises the degree from degree - 1 to degree.
void raise(Row& b, int degree, double t) {
    b[degree] = t * b[degree - 1];
    for (int i = degree - 1; i > 0; --i) {
        b[i] = (1 - t) * b[i] + t * b[i - 1];
    }
    b[0] *= 1 - t;
}

/// Derivatives are differences of the polynomials of lower degree.
Bernstein bernstein(int p, double t, double length) {
    Bernstein b;
    const auto at = [](const Row& row, int i, int degree) {
        return i < 0 || i > degree ? 0 : row[i];
    };
    Row row;
    row[0] = 1;
    for (int degree = 1; degree <= p - 2; ++degree) {
        raise(row, degree, t);
    }
    for (int i = 0; i <= p; ++i) {
        b.second[i] =
            p < 2 ? 0
                  : p * (p - 1) / (length * length) *
                        (at(row, i - 2, p - 2) - 2 * at(row, i - 1, p - 2) + at(row, i, p - 2));
    }
    if (p >= 2) {
        raise(row, p - 1, t);
    }
    for (int i = 0; i <= p; ++i) {
        b.first[i] = p / length * (at(row, i - 1, p - 1) - at(row, i, p - 1));
    }
    raise(row, p, t);
    b.values = row;
    return b;
}

} // namespace

BezierPatch::BezierPatch(const NurbsSurface& piece)
    : degreeU_(piece.u().degree()), degreeV_(piece.v().degree()),
      lower_(piece.u().first(), piece.v().first()), upper_(piece.u().last(), piece.v().last()),
      isRational_(piece.isRational()), points_(piece.controlPoints()),
      homogeneous_(piece.nControlPoints(), 4) {
    const Eigen::VectorXd weights =
        isRational_ ? piece.weights() : Eigen::VectorXd::Ones(points_.rows()).eval();
    homogeneous_ << weights.asDiagonal() * points_, weights;
}

BezierPatch::Derivatives BezierPatch::derivatives(const Eigen::Vector2d& parameters) const {
    const Eigen::Vector2d length = upper_ - lower_;
    const Eigen::Vector2d t = (parameters - lower_).cwiseQuotient(length);
    const Bernstein u = bernstein(degreeU_, t[0], length[0]);
    const Bernstein v = bernstein(degreeV_, t[1], length[1]);

    Eigen::Matrix<double, 6, 4, Eigen::RowMajor> sums = Eigen::Matrix<double, 6, 4>::Zero();
    for (int j = 0; j <= degreeV_; ++j) {
        Eigen::RowVector4d row = Eigen::RowVector4d::Zero(), rowU = row, rowUU = row;
        for (int i = 0; i <= degreeU_; ++i) {
            const auto point = homogeneous_.row(i + (degreeU_ + 1) * j);
            row += u.values[i] * point;
            rowU += u.first[i] * point;
            rowUU += u.second[i] * point;
        }
        sums.row(0) += v.values[j] * row;
        sums.row(1) += v.values[j] * rowU;
        sums.row(2) += v.first[j] * row;
        sums.row(3) += v.values[j] * rowUU;
        sums.row(4) += v.first[j] * rowU;
        sums.row(5) += v.second[j] * row;
    }
    Derivatives d = sums.leftCols<3>();
    if (!isRational_) {
        return d;
    }
    // Quotient rule, order by order.
    const auto w = sums.col(3);
    d.row(0) /= w[0];
    d.row(1) = (d.row(1) - w[1] * d.row(0)) / w[0];
    d.row(2) = (d.row(2) - w[2] * d.row(0)) / w[0];
    d.row(3) = (d.row(3) - 2 * w[1] * d.row(1) - w[3] * d.row(0)) / w[0];
    d.row(4) = (d.row(4) - w[1] * d.row(2) - w[2] * d.row(1) - w[4] * d.row(0)) / w[0];
    d.row(5) = (d.row(5) - 2 * w[2] * d.row(2) - w[5] * d.row(0)) / w[0];
    return d;
}

Eigen::Vector2d BezierPatch::guess(const Point& point) const {
    Eigen::Index nearest;
    (points_.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    const Eigen::Vector2d share(static_cast<double>(nearest % (degreeU_ + 1)) / degreeU_,
                                static_cast<double>(nearest / (degreeU_ + 1)) / degreeV_);
    return lower_ + share.cwiseProduct(upper_ - lower_);
}

} // namespace tokay::geometry
