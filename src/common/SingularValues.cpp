// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/SingularValues.hpp"

#include <Eigen/SVD>

namespace tokay {

SingularValues::SingularValues(const Eigen::MatrixXd& A) {
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV);
    U = svd.matrixU();
    values = svd.singularValues();
    V = svd.matrixV();
}

Eigen::Index SingularValues::rank(double relativeLimit) const {
    return values.size() == 0 ? 0 : (values.array() > relativeLimit * values[0]).count();
}

} // namespace tokay
