// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgeCoupling.hpp"
#include "igaStructure/kinematics/shell/edges/PenaltyStiffness.hpp"

#include <memory>
#include <vector>

namespace tokay::structure {

/// Constraints on moments of the displacement, or of its jump, and of the rotation
/// along an edge: Lagrange multipliers in the space of B-splines that the moments are
/// taken with, eliminated from the perturbed Lagrangian, whose perturbation is the
/// springs' compliance. The splines are two degrees lower than the functions of the
/// side of the lower degree, their spans as long as the longest element along the edge.
/// Source of the degree: Brivadis, Buffa, Wohlmuth & Wunderlich 2015
/// @param components  of the displacement, that are held
/// @param rotation    whether the rotation about the edge is held
std::vector<std::unique_ptr<EdgeCoupling>>
multiplierCouplings(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                    bool rotation, const PenaltyStiffness& stiffness);

} // namespace tokay::structure
