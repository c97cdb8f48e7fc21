// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/TensorPattern.hpp"

#include "common/errors.hpp"

#include <algorithm>
#include <limits>

namespace tokay::structure {

namespace {

// Neighbours of function i among n of one direction.
struct Range {
    int first;
    int count;
};

Range neighbours(int i, int degree, int n) {
    const int first = std::max(0, i - degree);
    return {first, std::min(n - 1, i + degree) - first + 1};
}

} // namespace

TensorPattern::TensorPattern(int nU, int nV, int degreeU, int degreeV)
    : nU_(nU), nV_(nV), degreeU_(degreeU), degreeV_(degreeV),
      starts_(static_cast<Eigen::Index>(nU) * nV + 1) {
    starts_[0] = 0;
    for (int j = 0; j < nV; ++j) {
        for (int i = 0; i < nU; ++i) {
            const Eigen::Index k = i + static_cast<Eigen::Index>(nU) * j;
            const Eigen::Index nNeighbours =
                neighbours(i, degreeU, nU).count * neighbours(j, degreeV, nV).count;
            starts_[k + 1] = starts_[k] + 4 * nNeighbours;
        }
    }
    if (starts_[starts_.size() - 1] > std::numeric_limits<int>::max()) {
        throw InputError("the discretisation is too fine: its matrix has more than 2^31 entries");
    }
}

SparseMatrix TensorPattern::zeroMatrix() const {
    const Eigen::Index n = 2 * (starts_.size() - 1);
    SparseMatrix matrix(n, n);
    matrix.resizeNonZeros(starts_[starts_.size() - 1]);
    int* columnStarts = matrix.outerIndexPtr();
    int* rows = matrix.innerIndexPtr();
    int entry = 0;
    columnStarts[0] = 0;
    for (int column = 0; column < n; ++column) {
        const int k = column / 2;
        const Range rangeU = neighbours(k % nU_, degreeU_, nU_);
        const Range rangeV = neighbours(k / nU_, degreeV_, nV_);
        for (int j = rangeV.first; j < rangeV.first + rangeV.count; ++j) {
            for (int row = 2 * (rangeU.first + nU_ * j), end = row + 2 * rangeU.count; row < end;
                 ++row) {
                rows[entry++] = row;
            }
        }
        columnStarts[column + 1] = entry;
    }
    std::fill(matrix.valuePtr(), matrix.valuePtr() + entry, 0.0);
    return matrix;
}

void TensorPattern::add(int firstU, int firstV, const Eigen::MatrixXd& element,
                        double* values) const {
    const int nLocalU = degreeU_ + 1;
    const int nLocalV = degreeV_ + 1;
    for (int b = 0; b < nLocalV; ++b) {
        const Range rangeV = neighbours(firstV + b, degreeV_, nV_);
        for (int a = 0; a < nLocalU; ++a) {
            const Range rangeU = neighbours(firstU + a, degreeU_, nU_);
            const Eigen::Index height = 2 * rangeU.count * rangeV.count;
            const Eigen::Index start = starts_[firstU + a + nU_ * (firstV + b)];
            for (int c = 0; c < 2; ++c) {
                const double* source = &element(0, 2 * (a + nLocalU * b) + c);
                for (int bb = 0; bb < nLocalV; ++bb, source += 2 * nLocalU) {
                    const Eigen::Index offset = 2 * (firstU - rangeU.first +
                                                     static_cast<Eigen::Index>(rangeU.count) *
                                                         (firstV + bb - rangeV.first));
                    double* target = values + start + c * height + offset;
                    for (int r = 0; r < 2 * nLocalU; ++r) {
                        target[r] += source[r];
                    }
                }
            }
        }
    }
}

} // namespace tokay::structure
