// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/ElementTangent.hpp"

#include <algorithm>

namespace tokay::structure {

void ElementTangent::start(int nFunctions) {
    nPoints_ = 0;
    if (nFunctions == nFunctions_) {
        sum_->setZero();
        return;
    }
    nFunctions_ = nFunctions;
    hessians_.resize(static_cast<std::size_t>(9 * nVectors_ * nVectors_) * most_);
    functions_.emplace(nVectors_ * most_, nFunctions);
    right_.emplace(nVectors_ * most_, 3 * nFunctions);
    sum_.emplace(3 * nFunctions, 3 * nFunctions);
    matrix_.resize(3 * nFunctions, 3 * nFunctions);
}

void ElementTangent::add(const double* derivatives, std::ptrdiff_t stride,
                         const Eigen::Ref<const Eigen::MatrixXd>& hessian) {
    for (int r = 0; r < nVectors_; ++r) {
        std::copy_n(derivatives + r * stride, nFunctions_,
                    functions_->row(nVectors_ * nPoints_ + r));
    }
    const int size = 3 * nVectors_;
    double* place = hessians_.data() + static_cast<std::ptrdiff_t>(size) * size * nPoints_;
    Eigen::Map<Eigen::MatrixXd>(place, size, size) = hessian;
    if (++nPoints_ == most_) {
        multiply();
    }
}

void ElementTangent::multiply() {
    const int size = 3 * nVectors_;
    locations_.clear();
    for (int point = 0; point < nPoints_; ++point) {
        locations_.push_back(hessians_.data() + static_cast<std::ptrdiff_t>(size) * size * point);
    }
    for (int d = 0; d < 3; ++d) {
        multiplyHessians(locations_, *functions_, nVectors_, nFunctions_, d, *right_);
        addProduct(*functions_, *right_, nVectors_ * nPoints_, nFunctions_, d, *sum_);
    }
    nPoints_ = 0;
}

const Eigen::MatrixXd& ElementTangent::finish() {
    multiply();
    for (int d = 0; d < 3; ++d) {
        for (int k = 0; k < nFunctions_; ++k) {
            const int line = d * nFunctions_ + k;
            const double* values = sum_->row(line);
            for (int column = line; column < 3 * nFunctions_; ++column) {
                const int other = 3 * (column % nFunctions_) + column / nFunctions_;
                matrix_(3 * k + d, other) = matrix_(other, 3 * k + d) = values[column];
            }
        }
    }
    return matrix_;
}

} // namespace tokay::structure
