// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"
#include "igaStructure/coupledRun/WetBoundary.hpp"

namespace tokay::structure {

/// A time step as the audit of conservation looks at it.
struct AuditedStep {
    const Eigen::VectorXd& forces; ///< on the fluid's faces, the last of the step
    Eigen::VectorXd before;        ///< displacement of the structure, accepted before
    Eigen::VectorXd mapped;        ///< that at which the forces were mapped
    Eigen::VectorXd after;         ///< accepted now
    double deltaT;                 ///< [s]
};

/// Force, moment, power and swept volume of the interface on the structure's side.
channel::InterfaceBalance interfaceBalance(const WetBoundary& boundary, const AuditedStep& step);

} // namespace tokay::structure
