// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/vonMises.hpp"

#include <cmath>

namespace tokay::structure {

Eigen::MatrixXd vonMises(const Eigen::MatrixXd& stress) {
    Eigen::MatrixXd values(1, stress.cols());
    for (Eigen::Index k = 0; k < stress.cols(); ++k) {
        const auto s = stress.col(k);
        const double normal =
            0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2));
        values(0, k) = std::sqrt(normal + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
    }
    return values;
}

} // namespace tokay::structure
