// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::structure {

/// A field of a plane line at a parameter: its value and derivative by xi.
struct BeamField {
    Eigen::Vector2d value;
    Eigen::Vector2d slope;
};

/// Motion of a point of a section that stays plane and normal to the axis, at
/// a distance zeta to its left.
/// @param reference  axis and its derivative, before the motion
/// @param isLinear   small rotations
Eigen::Vector2d sectionDisplacement(const BeamField& reference, const BeamField& displacement,
                                    double zeta, bool isLinear);

Eigen::Vector2d sectionVelocity(const BeamField& reference, const BeamField& displacement,
                                const BeamField& velocity, double zeta, bool isLinear);

Eigen::Vector2d sectionAcceleration(const BeamField& reference, const BeamField& displacement,
                                    const BeamField& velocity, const BeamField& acceleration,
                                    double zeta, bool isLinear);

} // namespace tokay::structure
