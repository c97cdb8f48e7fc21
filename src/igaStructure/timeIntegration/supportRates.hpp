// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"

namespace tokay::structure {

/// Rates of the prescribed motion of supports; empty if they are at rest.
struct SupportRates {
    Eigen::VectorXd velocity;     ///< [m/s]
    Eigen::VectorXd acceleration; ///< [m/s^2]
};

/// Rates at a time, by the cubic through the motion then and at three times within an
/// interval that begins or ends there.
/// @param interval  its length; negative if it ends at the time [s]
SupportRates supportRates(const StructuralModel& model, double time, double interval);

/// A body that starts at rest and undeformed cannot have supports elsewhere: the jump
/// would have no finite force.
/// @throws InputError if a support is displaced at the start
void requireSupportsAtRest(const StructuralModel& model, double startTime);

} // namespace tokay::structure
