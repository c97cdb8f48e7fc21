// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/rbf/LinearPolynomial.hpp"

#include "common/dense/SymmetricEigen.hpp"

namespace tokay::mapper {

LinearPolynomial::LinearPolynomial(const Points& cloud, double leastExtent)
    : centre_(cloud.colwise().mean()) {
    const Points centred = cloud.rowwise() - centre_.transpose();
    const SymmetricEigen principal(centred.transpose() * centred);
    const double largest = std::sqrt(std::max(principal.values[2], 0.0));
    const double extent = std::sqrt(centred.rowwise().squaredNorm().maxCoeff());
    axes_.resize(0, 3);
    for (int i = 2; i >= 0; --i) {
        const double along = std::sqrt(std::max(principal.values[i], 0.0));
        if (!(along > leastExtent * largest) || extent == 0) {
            break;
        }
        axes_.conservativeResize(axes_.rows() + 1, 3);
        axes_.row(axes_.rows() - 1) =
            principal.vectors.col(i).transpose() * (largest / along) / extent;
    }
}

Eigen::MatrixXd LinearPolynomial::values(const Points& points) const {
    Eigen::MatrixXd values(points.rows(), size());
    values.col(0).setOnes();
    values.rightCols(nAxes()) = (points.rowwise() - centre_.transpose()) * axes_.transpose();
    return values;
}

} // namespace tokay::mapper
