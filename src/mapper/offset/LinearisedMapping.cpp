// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/offset/LinearisedMapping.hpp"

#include "mapper/Stopwatch.hpp"

namespace tokay::mapper {

namespace {

// A point's components one after the other, as the matrix has them.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

template <class Operator>
Eigen::MatrixXd product(const Operator& matrix, const Eigen::MatrixXd& values) {
    const Rows rows = values;
    const Eigen::VectorXd result =
        matrix * Eigen::Map<const Eigen::VectorXd>(rows.data(), rows.size());
    return Eigen::Map<const Rows>(result.data(), result.size() / 3, 3);
}

RowSparseMatrix identity(Eigen::Index n) {
    RowSparseMatrix matrix(n, n);
    matrix.setIdentity();
    return matrix;
}

} // namespace

LinearisedMapping::LinearisedMapping(const OffsetMapping& mapping)
    : LinearisedMapping(mapping, identity(mapping.report().nPoints)) {}

LinearisedMapping::LinearisedMapping(const OffsetMapping& mapping, const RowSparseMatrix& shares) {
    const Stopwatch watch;
    derivative_ = mapping.derivative(shares);
    report_ = mapping.report();
    report_.bytes = bytesOf(derivative_);
    report_.seconds += watch.seconds();
}

Eigen::MatrixXd LinearisedMapping::apply(const Eigen::MatrixXd& values) const {
    return product(derivative_, values);
}

Eigen::MatrixXd LinearisedMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    return product(derivative_.transpose(), forces);
}

} // namespace tokay::mapper
