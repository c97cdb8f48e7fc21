// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/LinePattern.hpp"

namespace tokay::structure {

LinePattern::LinePattern(int dimension, int nControlPoints, int degree,
                         std::vector<int> firstFunctions)
    : dimension_(dimension), firstFunctions_(std::move(firstFunctions)),
      zero_(dimension * nControlPoints, dimension * nControlPoints) {
    const int n = dimension * (degree + 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int first : firstFunctions_) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                entries.emplace_back(dimension * first + i, dimension * first + j, 0.0);
            }
        }
    }
    zero_.setFromTriplets(entries.begin(), entries.end());
}

void LinePattern::add(int element, const Eigen::MatrixXd& matrix, SparseMatrix& sum) const {
    const int first = dimension_ * firstFunctions_[element];
    for (int j = 0; j < matrix.cols(); ++j) {
        // The element's rows follow each other in the column.
        const int start = sum.outerIndexPtr()[first + j];
        const int offset = first - sum.innerIndexPtr()[start];
        double* target = sum.valuePtr() + start + offset;
        for (int i = 0; i < matrix.rows(); ++i) {
            target[i] += matrix(i, j);
        }
    }
}

} // namespace tokay::structure
