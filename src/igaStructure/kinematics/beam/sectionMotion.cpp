// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/sectionMotion.hpp"

#include "igaStructure/kinematics/beam/planeVectors.hpp"

namespace tokay::structure {

using Eigen::Vector2d;

namespace {

// Rate of the angle of a tangent.
double angleRate(const Vector2d& tangent, const Vector2d& rate) {
    return cross(tangent, rate) / tangent.squaredNorm();
}

} // namespace

Vector2d sectionDisplacement(const BeamField& reference, const BeamField& displacement, double zeta,
                             bool isLinear) {
    if (isLinear) {
        return sectionVelocity(reference, displacement, displacement, zeta, true);
    }
    return displacement.value + zeta * turned((reference.slope + displacement.slope).normalized() -
                                              reference.slope.normalized());
}

Vector2d sectionVelocity(const BeamField& reference, const BeamField& displacement,
                         const BeamField& velocity, double zeta, bool isLinear) {
    const Vector2d a = isLinear ? reference.slope : Vector2d(reference.slope + displacement.slope);
    return velocity.value - zeta * angleRate(a, velocity.slope) * a.normalized();
}

Vector2d sectionAcceleration(const BeamField& reference, const BeamField& displacement,
                             const BeamField& velocity, const BeamField& acceleration, double zeta,
                             bool isLinear) {
    if (isLinear) {
        return sectionVelocity(reference, displacement, acceleration, zeta, true);
    }
    const Vector2d a = reference.slope + displacement.slope;
    const double rate = angleRate(a, velocity.slope);
    const double angleAcceleration =
        angleRate(a, acceleration.slope) - 2 * rate * a.dot(velocity.slope) / a.squaredNorm();
    return acceleration.value - zeta * (angleAcceleration * a + rate * rate * turned(a)) / a.norm();
}

} // namespace tokay::structure
