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
    Eigen::VectorXd reaction;     ///< of supports, on the unknowns that they fix, else 0 [N]
};

/// Energies of a structure [J], per unit depth where its forces are.
struct Energies {
    double kinetic = 0;
    double strain = 0;
    double externalWork = 0; ///< done by external forces and moving supports since the start
    double dampingWork = 0;  ///< taken by Rayleigh damping since the start
};

} // namespace tokay::structure
