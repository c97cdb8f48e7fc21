#include "igaStructure/model/LinePattern.hpp"

namespace tokay::structure {

LinePattern::LinePattern(int nControlPoints, int degree, std::vector<int> firstFunctions)
    : firstFunctions_(std::move(firstFunctions)), zero_(2 * nControlPoints, 2 * nControlPoints) {
    const int n = 2 * (degree + 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int first : firstFunctions_) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                entries.emplace_back(2 * first + i, 2 * first + j, 0.0);
            }
        }
    }
    zero_.setFromTriplets(entries.begin(), entries.end());
}

void LinePattern::add(int element, const Eigen::MatrixXd& matrix, SparseMatrix& sum) const {
    const int first = 2 * firstFunctions_[element];
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
