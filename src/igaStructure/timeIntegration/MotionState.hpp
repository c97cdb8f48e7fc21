// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::structure {

/// Motion of a structure at one time.
struct MotionState {
    double time = 0;              ///< [s]
    Eigen::VectorXd displacement; ///< [m]
    Eigen::VectorXd velocity;     ///< [m/s]
    Eigen::VectorXd acceleration; ///< [m/s^2]
    Eigen::VectorXd force;        ///< external but for follower loads, interface included [N]
};

} // namespace tokay::structure
