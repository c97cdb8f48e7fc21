// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgePoint.hpp"

namespace tokay::structure {

/// Springs along an edge, in units of the stiffness that an element there has, h being its
/// size across the edge. In a time step an element resists by its inertia too, and the
/// shorter the step the more: a spring that scales with the elastic stiffness alone gives way
/// in short ones. So those against displacement have a mass as well, which counts as the
/// element's does. Those against rotation have none: held as firmly, an element that the edge
/// cuts would not move at all.
struct PenaltyStiffness {
    double factor;
    double membrane; ///< E t / (1 - nu^2) [N/m]
    double bending;  ///< E t^3 / 12 / (1 - nu^2) [N m]; 0: a membrane

    /// Against displacement in all directions, per length: membrane / h [N/m^2].
    double ofAnyDisplacement(const EdgePoint& point) const;
    /// Against displacement, per length: membrane / h along the surface, and across it
    /// bending / h^3; the former in all directions for a membrane and where the
    /// surface has a kink, since one side's membrane is in the other one's way [N/m^2].
    Eigen::Matrix3d ofDisplacement(const EdgePoint& point) const;
    /// Against rotation, per length [N].
    double ofRotation(const EdgePoint& point) const;
    /// Of a spring against displacement, per length: that of the lighter element [kg/m].
    double massOfDisplacement(const EdgePoint& point) const;
};

} // namespace tokay::structure
