// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/PenaltyStiffness.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::structure {

namespace {

double elementSize(const EdgePoint& point) {
    return point.other ? std::min(point.side.elementSize(), point.other->elementSize())
                       : point.side.elementSize();
}

double massPerArea(const EdgePoint& point) {
    const double own = point.side.patch->massPerArea();
    return point.other ? std::min(own, point.other->patch->massPerArea()) : own;
}

bool isKink(const EdgePoint& point) {
    constexpr double smooth = 1e-3; // square of the angle; curved edges meet to some digits only
    return point.other && 1 - std::pow(point.side.normal().dot(point.other->normal()), 2) > smooth;
}

} // namespace

double PenaltyStiffness::ofAnyDisplacement(const EdgePoint& point) const {
    return factor * membrane / elementSize(point);
}

Eigen::Matrix3d PenaltyStiffness::ofDisplacement(const EdgePoint& point) const {
    const double h = elementSize(point);
    const double along = ofAnyDisplacement(point);
    const double across = bending > 0 && !isKink(point) ? factor * bending / (h * h * h) : along;
    const Eigen::Vector3d normal = point.side.normal();
    return along * Eigen::Matrix3d::Identity() + (across - along) * normal * normal.transpose();
}

double PenaltyStiffness::ofRotation(const EdgePoint& point) const {
    return factor * bending / elementSize(point);
}

double PenaltyStiffness::massOfDisplacement(const EdgePoint& point) const {
    return factor * massPerArea(point) * elementSize(point);
}

} // namespace tokay::structure
