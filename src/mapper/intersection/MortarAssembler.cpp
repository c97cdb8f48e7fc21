// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/MortarAssembler.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>

namespace tokay::mapper {

namespace {

void append(const std::vector<int>& rows, const std::vector<int>& columns,
            const Eigen::MatrixXd& block, std::vector<Eigen::Triplet<double>>& entries) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < columns.size(); ++j) {
            if (block(i, j) != 0) {
                entries.emplace_back(rows[i], columns[j], block(i, j));
            }
        }
    }
}

} // namespace

MortarAssembler::MortarAssembler(int nTo, int nFrom, MortarBasis basis, int nElements)
    : nTo_(nTo), nFrom_(nFrom), basis_(basis), elements_(nElements), isOnInterface_(nTo, 0) {
    assert(nElements == 0 || basis == MortarBasis::standard);
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

void MortarAssembler::add(const std::vector<int>& toValues, const std::vector<int>& fromValues,
                          const Eigen::MatrixXd& mass, const Eigen::MatrixXd& cross) {
    Part& part = partOf(0, toValues);
    assert(part.toValues == toValues);
    part.mass += mass;
    for (std::size_t j = 0; j < fromValues.size(); ++j) {
        const int number = part.column(fromValues[j]);
        part.cross.col(number) += cross.col(static_cast<Eigen::Index>(j));
    }
}

void MortarAssembler::addUnmatched(const Functions& to) {
    for (const int value : to.values) {
        addUnmatched(value);
    }
}

void MortarAssembler::close(const Part& part) {
    append(part.toValues, part.fromValues, part.cross, cross_);
    if (elements_.empty()) {
        append(part.toValues, part.toValues, part.mass, mass_);
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

RowSparseMatrix MortarAssembler::massMatrix() const {
    std::vector<Eigen::Triplet<double>> entries = mass_;
    for (const ElementMass& element : elements_) {
        append(element.values, element.values, element.matrix, entries);
    }
    RowSparseMatrix matrix(nTo_, nTo_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

RowSparseMatrix MortarAssembler::crossMatrix() const {
    RowSparseMatrix matrix(nTo_, nFrom_);
    matrix.setFromTriplets(cross_.begin(), cross_.end());
    return matrix;
}

int MortarAssembler::nUncovered(const RowSparseMatrix& massMatrix) const {
    int n = 0;
    for (int i = 0; i < nTo_; ++i) {
        n += isOnInterface_[i] && massMatrix.coeff(i, i) <= 0;
    }
    return n;
}

} // namespace tokay::mapper
