// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/MortarAssembler.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace tokay::mapper {

namespace {

/// Indices that put values into ascending order.
std::vector<int> ascendingOrder(const std::vector<int>& values) {
    std::vector<int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) { return values[i] < values[j]; });
    return order;
}

std::vector<int> ordered(const std::vector<int>& values, const std::vector<int>& order) {
    std::vector<int> sorted;
    sorted.reserve(order.size());
    for (const int i : order) {
        sorted.push_back(values[i]);
    }
    return sorted;
}

void addRows(const std::vector<int>& rows, const std::vector<int>& columns,
             const Eigen::Ref<const Eigen::MatrixXd>& block, SparseSum& sum) {
    const std::vector<int> order = ascendingOrder(columns), sorted = ordered(columns, order);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        sum.add(rows[i], sorted, block.row(static_cast<Eigen::Index>(i))(order));
    }
}

} // namespace

MortarAssembler::MortarAssembler(int nTo, int nFrom, MortarBasis basis, int nElements)
    : nTo_(nTo), basis_(basis), sourceLeads_(nElements > 0), elements_(nElements), mass_(nTo, nTo),
      cross_(sourceLeads_ ? SparseSum(nFrom, nTo) : SparseSum(nTo, nFrom)), isOnInterface_(nTo, 0) {
    assert(!sourceLeads_ || basis == MortarBasis::standard);
}

int MortarAssembler::Part::column(int fromValue) {
    const auto found = std::find(fromValues.begin(), fromValues.end(), fromValue);
    const int number = static_cast<int>(found - fromValues.begin());
    if (found == fromValues.end()) {
        fromValues.push_back(fromValue);
        if (cross.cols() < number + 1) {
            cross.conservativeResize(Eigen::NoChange, 2 * number + 8);
        }
        cross.col(number).setZero();
    }
    return number;
}

void MortarAssembler::Part::add(double weight, const Functions& to, const Functions& from) {
    assert(toValues == to.values);
    for (Eigen::Index j = 0; j < mass.cols(); ++j) {
        mass.col(j).noalias() += weight * to.weights[j] * to.weights;
    }
    for (std::size_t j = 0; j < from.values.size(); ++j) {
        const int number = column(from.values[j]);
        cross.col(number).noalias() += weight * from.weights[j] * to.weights;
    }
}

/// Functions A N with A M = D = diag(M 1): mass and cross matrix keep their row
/// sums, so constants stay exact.
void MortarAssembler::Part::makeDual() {
    const Eigen::VectorXd sums = mass.rowwise().sum();
    cross = sums.asDiagonal() * mass.ldlt().solve(cross).eval();
    mass = sums.asDiagonal();
}

MortarAssembler::Part& MortarAssembler::partOf(int element, const std::vector<int>& toValues) {
    for (std::size_t i = 0; i < nParts_; ++i) {
        if (parts_[i].element == element) {
            return parts_[i];
        }
    }
    if (parts_.size() == nParts_) {
        parts_.emplace_back();
    }
    Part& part = parts_[nParts_++];
    const auto n = static_cast<Eigen::Index>(toValues.size());
    part.element = element;
    part.toValues = toValues;
    part.fromValues.clear();
    part.mass = Eigen::MatrixXd::Zero(n, n);
    part.cross.resize(n, part.cross.cols());
    return part;
}

void MortarAssembler::add(double weight, const Functions& to, const Functions& from, int element) {
    partOf(element, to.values).add(weight, to, from);
}

void MortarAssembler::add(const CornerFunctions& to, const CornerFunctions& from,
                          const Eigen::Matrix3d& mass, const Eigen::Matrix3d& cross) {
    Part& part = partOf(0, to.values);
    assert(part.toValues == to.values);
    // Lazy products of small matrices take no memory.
    onTo_ = to.weights.lazyProduct(mass);
    part.mass += onTo_.lazyProduct(to.weights.transpose());
    onTo_ = to.weights.lazyProduct(cross);
    for (std::size_t j = 0; j < from.values.size(); ++j) {
        const int number = part.column(from.values[j]);
        const Eigen::Vector3d weights = from.weights.row(static_cast<Eigen::Index>(j));
        part.cross.col(number) += onTo_.lazyProduct(weights);
    }
}

void MortarAssembler::addUnmatched(const std::vector<int>& toValues) {
    for (const int value : toValues) {
        addUnmatched(value);
    }
}

void MortarAssembler::addCross(const Part& part) {
    const auto cross = part.cross.leftCols(static_cast<Eigen::Index>(part.fromValues.size()));
    if (!sourceLeads_) {
        addRows(part.toValues, part.fromValues, cross, cross_);
    } else {
        addRows(part.fromValues, part.toValues, Eigen::MatrixXd(cross.transpose()), cross_);
    }
}

void MortarAssembler::close(const Part& part) {
    addCross(part);
    if (!sourceLeads_) {
        addRows(part.toValues, part.toValues, part.mass, mass_);
        return;
    }
    ElementMass& element = elements_[part.element];
    if (element.values.empty()) {
        element = {part.toValues, part.mass};
    } else {
        element.matrix += part.mass;
    }
}

void MortarAssembler::endGroup() {
    for (std::size_t i = 0; i < nParts_; ++i) {
        if (basis_ == MortarBasis::dual) {
            parts_[i].makeDual();
        }
        close(parts_[i]);
    }
    nParts_ = 0;
}

RowSparseMatrix MortarAssembler::takeMass() {
    for (const ElementMass& element : std::exchange(elements_, {})) {
        addRows(element.values, element.values, element.matrix, mass_);
    }
    return std::exchange(mass_, SparseSum(0, 0)).matrix();
}

RowSparseMatrix MortarAssembler::takeCross() {
    const RowSparseMatrix cross = std::exchange(cross_, SparseSum(0, 0)).matrix();
    return sourceLeads_ ? RowSparseMatrix(cross.transpose()) : cross;
}

int MortarAssembler::nUncovered(const RowSparseMatrix& massMatrix) const {
    int n = 0;
    for (int i = 0; i < nTo_; ++i) {
        n += isOnInterface_[i] && massMatrix.coeff(i, i) <= 0;
    }
    return n;
}

} // namespace tokay::mapper
