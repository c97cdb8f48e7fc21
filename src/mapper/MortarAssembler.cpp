#include "mapper/MortarAssembler.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>

namespace tokay::mapper {

MortarAssembler::MortarAssembler(int nTo, int nFrom, MortarBasis basis)
    : nTo_(nTo), nFrom_(nFrom), basis_(basis), isOnInterface_(nTo, 0), isCovered_(nTo, 0) {}

int MortarAssembler::column(int fromValue) {
    const auto found = std::find(fromValues_.begin(), fromValues_.end(), fromValue);
    const int number = static_cast<int>(found - fromValues_.begin());
    if (found == fromValues_.end()) {
        fromValues_.push_back(fromValue);
        if (localCross_.cols() < number + 1)
            localCross_.conservativeResize(Eigen::NoChange, 2 * number + 8);
        localCross_.col(number).setZero();
    }
    return number;
}

void MortarAssembler::add(double weight, const Functions& to, const Functions& from) {
    if (toValues_.empty()) {
        toValues_ = to.values;
        const Eigen::Index n = to.weights.size();
        localMass_ = Eigen::MatrixXd::Zero(n, n);
        localCross_.resize(n, localCross_.cols());
    }
    assert(toValues_ == to.values);
    localMass_.noalias() += weight * to.weights * to.weights.transpose();
    for (std::size_t j = 0; j < from.values.size(); ++j) {
        const int number = column(from.values[j]);
        localCross_.col(number).noalias() += weight * from.weights[j] * to.weights;
    }
}

void MortarAssembler::addUnmatched(const Functions& to) {
    for (const int value : to.values)
        isOnInterface_[value] = 1;
}

void MortarAssembler::endElement() {
    if (basis_ == MortarBasis::dual && !toValues_.empty()) {
        // Dual functions A N with A M = D = diag(M 1): the pair keeps its row
        // sums, so constants stay exact.
        const Eigen::VectorXd sums = localMass_.rowwise().sum();
        const auto factored = localMass_.ldlt();
        localCross_ = sums.asDiagonal() * factored.solve(localCross_).eval();
        localMass_ = sums.asDiagonal();
    }
    for (std::size_t i = 0; i < toValues_.size(); ++i) {
        isOnInterface_[toValues_[i]] = 1;
        isCovered_[toValues_[i]] |= localMass_(i, i) > 0;
        for (std::size_t j = 0; j < toValues_.size(); ++j)
            if (localMass_(i, j) != 0)
                mass_.emplace_back(toValues_[i], toValues_[j], localMass_(i, j));
        for (std::size_t j = 0; j < fromValues_.size(); ++j)
            if (localCross_(i, j) != 0)
                cross_.emplace_back(toValues_[i], fromValues_[j], localCross_(i, j));
    }
    toValues_.clear();
    fromValues_.clear();
}

SparseMatrix MortarAssembler::massMatrix() const {
    SparseMatrix matrix(nTo_, nTo_);
    matrix.setFromTriplets(mass_.begin(), mass_.end());
    return matrix;
}

SparseMatrix MortarAssembler::crossMatrix() const {
    SparseMatrix matrix(nTo_, nFrom_);
    matrix.setFromTriplets(cross_.begin(), cross_.end());
    return matrix;
}

int MortarAssembler::nUncovered() const {
    int n = 0;
    for (int i = 0; i < nTo_; ++i)
        n += isOnInterface_[i] && !isCovered_[i];
    return n;
}

} // namespace tokay::mapper
