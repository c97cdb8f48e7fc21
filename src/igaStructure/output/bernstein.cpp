// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/output/bernstein.hpp"

#include "common/dense/DenseLu.hpp"

#include <cmath>

namespace tokay::structure {

Eigen::MatrixXd bernsteinInverse(int degree) {
    Eigen::MatrixXd values(degree + 1, degree + 1);
    for (int k = 0; k <= degree; ++k) {
        const double s = static_cast<double>(k) / degree;
        double binomial = 1;
        for (int i = 0; i <= degree; ++i) {
            values(k, i) = binomial * std::pow(s, i) * std::pow(1 - s, degree - i);
            binomial *= static_cast<double>(degree - i) / (i + 1);
        }
    }
    return DenseLu(values).solve(Eigen::MatrixXd::Identity(degree + 1, degree + 1));
}

} // namespace tokay::structure
