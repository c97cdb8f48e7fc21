// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/history/FilteredQr.hpp"

#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <cassert>
#include <cmath>

namespace tokay::coupling {
namespace {

/// Below this share of the column, what is left of it is rounding error.
constexpr double columnRounding = 1e-12;

/// Subtracts the part of `vector` within the span of q, twice because once
/// leaves rounding errors of the size of what was subtracted.
Eigen::VectorXd orthogonalise(const std::vector<Eigen::VectorXd>& q, Eigen::VectorXd& vector) {
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(q.size()));
    for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t i = 0; i < q.size(); ++i) {
            const double share = q[i].dot(vector);
            vector -= share * q[i];
            coefficients[static_cast<Eigen::Index>(i)] += share;
        }
    }
    return coefficients;
}

} // namespace

const SchemaOf<FilterOptions>& FilterOptions::schema() {
    static const Choices<QrFilter> filters = {
        {"qr1", QrFilter::qr1, "by the diagonal of R relative to its norm."},
        {"qr2", QrFilter::qr2,
         "by the part of a difference orthogonal to the newer ones relative to its length."}};
    static const SchemaOf<FilterOptions> schema = {
        {"filter", &FilterOptions::filter, filters, "Which differences count as dependent."},
        {"filterLimit", &FilterOptions::filterLimit, "[0, 1)", "", "Limit of the filter."}};
    return schema;
}

std::vector<int> FilteredQr::prepend(const Eigen::VectorXd& column) {
    const int n = nColumns();
    Eigen::VectorXd rest = column;
    const Eigen::VectorXd shares = orthogonalise(q_, rest);
    double restNorm = rest.norm();
    if (restNorm <= columnRounding * column.norm()) {
        rest.setZero(); // spans nothing new: the filter will drop an older column
        restNorm = 0;
    } else {
        rest /= restNorm;
    }

    Eigen::MatrixXd r = Eigen::MatrixXd::Zero(n + 1, n + 1);
    r.col(0) << shares, restNorm;
    r.topRightCorner(n, n) = r_;
    r_ = std::move(r);
    q_.push_back(std::move(rest));
    for (int row = n - 1; row >= 0; --row) {
        rotate(row, 0);
    }

    std::vector<int> dropped;
    for (int i = 0; i < nColumns();) {
        if (isDependent(i)) {
            remove(i);
            dropped.push_back(i);
        } else {
            ++i;
        }
    }
    return dropped;
}

void FilteredQr::remove(int column) {
    const int n = nColumns();
    assert(column >= 0 && column < n);
    const int nBehind = n - 1 - column;
    r_.middleCols(column, nBehind) = r_.rightCols(nBehind).eval();
    r_.conservativeResize(n, n - 1);
    for (int row = column; row < n - 1; ++row) {
        rotate(row, row);
    }
    r_.conservativeResize(n - 1, n - 1);
    q_.pop_back();
}

void FilteredQr::clear() {
    q_.clear();
    r_.resize(0, 0);
}

void FilteredQr::save(StateWriter& state) const {
    state.matrix(r_);
    for (const Eigen::VectorXd& vector : q_) {
        state.matrix(vector);
    }
}

void FilteredQr::restore(StateReader& state) {
    r_ = state.matrix();
    if (r_.rows() != r_.cols()) {
        throw channel::PeerError("a triangular factor is not square");
    }
    q_.clear();
    for (Eigen::Index i = 0; i < r_.cols(); ++i) {
        q_.push_back(state.interfaceVector());
    }
}

/// Turns rows `row` and `row + 1` of R, and the same columns of Q, so that
/// entry (row + 1, column) of R becomes zero.
void FilteredQr::rotate(int row, int column) {
    const double length = std::hypot(r_(row, column), r_(row + 1, column));
    if (length == 0) {
        return;
    }
    const double c = r_(row, column) / length;
    const double s = r_(row + 1, column) / length;
    const Eigen::RowVectorXd upper = r_.row(row);
    r_.row(row) = c * upper + s * r_.row(row + 1);
    r_.row(row + 1) = c * r_.row(row + 1) - s * upper;
    r_(row + 1, column) = 0;
    Eigen::VectorXd& first = q_[static_cast<std::size_t>(row)];
    Eigen::VectorXd& second = q_[static_cast<std::size_t>(row) + 1];
    const Eigen::VectorXd old = first;
    first = c * old + s * second;
    second = c * second - s * old;
}

bool FilteredQr::isDependent(int column) const {
    const double scale = options_.filter == QrFilter::qr1 ? r_.norm() : r_.col(column).norm();
    return std::abs(r_(column, column)) <= std::max(options_.filterLimit, columnRounding) * scale;
}

Eigen::VectorXd FilteredQr::solve(const Eigen::VectorXd& rightHandSide) const {
    Eigen::VectorXd coefficients(nColumns());
    for (int i = 0; i < nColumns(); ++i) {
        coefficients[i] = q_[static_cast<std::size_t>(i)].dot(rightHandSide);
    }
    r_.triangularView<Eigen::Upper>().solveInPlace(coefficients);
    return coefficients;
}

} // namespace tokay::coupling
