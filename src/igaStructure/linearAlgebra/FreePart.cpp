// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/linearAlgebra/FreePart.hpp"

#include "common/errors.hpp"

#include <cassert>
#include <cmath>

namespace tokay::structure {

FreePart::FreePart(const SparseMatrix& pattern, const std::vector<bool>& fixed, Triangles triangles)
    : nWhole_(pattern.cols()), starts_{0} {
    std::vector<int> number(pattern.cols(), -1);
    for (int k = 0; k < pattern.cols(); ++k) {
        if (!fixed[k]) {
            number[k] = size();
            unknowns_.push_back(k);
        }
    }
    if (unknowns_.empty()) {
        throw SolverError("the supports fix every unknown; nothing is left to solve");
    }
    for (int column : unknowns_) {
        for (int slot = pattern.outerIndexPtr()[column]; slot < pattern.outerIndexPtr()[column + 1];
             ++slot) {
            const int row = pattern.innerIndexPtr()[slot];
            if (row == column) {
                diagonalSlots_.push_back(slot);
            }
            if (!fixed[row] && (row >= column || triangles == Triangles::both)) {
                rows_.push_back(number[row]);
                slots_.push_back(slot);
            }
        }
        starts_.push_back(static_cast<int>(rows_.size()));
    }
    assert(diagonalSlots_.size() == unknowns_.size());
}

void FreePart::setScaled(const SparseMatrix& matrix, double* values) {
    scales_.assign(size(), 1);
    for (int k = 0; k < size(); ++k) {
        const double diagonal = std::abs(matrix.valuePtr()[diagonalSlots_[k]]);
        if (diagonal > 0) {
            scales_[k] = 1 / std::sqrt(diagonal);
        }
    }
    for (int column = 0; column < size(); ++column) {
        for (int k = starts_[column]; k < starts_[column + 1]; ++k) {
            values[k] = scales_[column] * matrix.valuePtr()[slots_[k]] * scales_[rows_[k]];
        }
    }
}

void FreePart::reduce(const Eigen::Ref<const Eigen::VectorXd>& whole, double* reduced) const {
    for (int k = 0; k < size(); ++k) {
        reduced[k] = scales_[k] * whole[unknowns_[k]];
    }
}

Eigen::VectorXd FreePart::extend(const double* reduced) const {
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(nWhole_);
    for (int k = 0; k < size(); ++k) {
        whole[unknowns_[k]] = scales_[k] * reduced[k];
    }
    return whole;
}

double FreePart::bytes() const {
    const double perEntry = sizeof(double) + 2 * sizeof(int);
    return perEntry * static_cast<double>(rows_.size());
}

} // namespace tokay::structure
