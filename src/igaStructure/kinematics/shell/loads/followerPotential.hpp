// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"

namespace tokay::structure {

/// True if the follower loads of a shell have a potential, so that their
/// derivative is symmetric: no line moments, and pressures that are uniform on a
/// surface whose rim is held. Held means: two components, or the one across a
/// plane in which the rim lies. Joints count as closed, up to their compliance.
/// Source: Schweizerhof & Ramm 1984
bool followersHavePotential(const ShellDescription& shell);

} // namespace tokay::structure
