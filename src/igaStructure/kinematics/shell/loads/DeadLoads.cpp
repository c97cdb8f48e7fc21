// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/loads/DeadLoads.hpp"

#include <algorithm>

namespace tokay::structure {

using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

void scatter(const PatchLocation& place, const Vector3d& load, VectorXd& force) {
    for (std::size_t k = 0; k < place.nodes.size(); ++k) {
        force.segment<3>(3 * place.nodes[k]) += place.N(0, static_cast<Eigen::Index>(k)) * load;
    }
}

} // namespace

DeadLoads::DeadLoads(const ShellLoads& loads, const geometry::BrepModel& model,
                     const ShellPatches& patches, const ElementRows& sweep, int nUnknowns)
    : loads_(loads), model_(model), patches_(patches), sweep_(sweep),
      constant_(VectorXd::Zero(nUnknowns)) {
    add(0, false, constant_);
}

const VectorXd& DeadLoads::at(double time) {
    force_ = constant_;
    add(time, true, force_);
    return force_;
}

void DeadLoads::add(double time, bool varying, VectorXd& force) const {
    if (hasAreaLoads(varying)) {
        addOnAreas(time, varying, force);
    }
    addOnEdges(time, varying, force);
    addAtPoints(time, varying, force);
}

bool DeadLoads::hasAreaLoads(bool varying) const {
    const auto counts = [&](const auto& field) { return field.dependsOnTime == varying; };
    return std::any_of(loads_.tractions.begin(), loads_.tractions.end(),
                       [&](const auto& load) { return counts(load.traction); }) ||
           std::any_of(loads_.gravities.begin(), loads_.gravities.end(), counts);
}

Vector3d DeadLoads::areaLoad(int face, const geometry::Point& place, double time,
                             bool varying) const {
    Vector3d sum = Vector3d::Zero();
    for (const ShellLoads::Traction& load : loads_.tractions) {
        if (load.face == face && load.traction.dependsOnTime == varying) {
            sum += load.traction.value(place, time);
        }
    }
    for (const VectorField& gravity : loads_.gravities) {
        if (gravity.dependsOnTime == varying) {
            sum += patches_[face]->massPerArea() * gravity.value(place, time);
        }
    }
    return sum;
}

void DeadLoads::addOnAreas(double time, bool varying, VectorXd& force) const {
    // One thread: formulas of a case file are not made for several.
    sweep_.forEachElement(1, [&](ShellElement& element, int, int) {
        const auto isOwn = [&](const auto& patch) { return patch.get() == &element.patch(); };
        const auto face = std::find_if(patches_.begin(), patches_.end(), isOwn);
        ShellElement::Coefficients local =
            ShellElement::Coefficients::Zero(3, element.nFunctions());
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const Vector3d load =
                element.area() * areaLoad(static_cast<int>(face - patches_.begin()),
                                          element.position(), time, varying);
            for (int k = 0; k < element.nFunctions(); ++k) {
                local.col(k) += element.functions().row(0)[k] * load;
            }
        }
        element.scatter(local, force);
    });
}

void DeadLoads::addOnEdges(double time, bool varying, VectorXd& force) const {
    for (const ShellLoads::EdgeForce& load : loads_.edgeForces) {
        if (load.force.dependsOnTime != varying) {
            continue;
        }
        for (const EdgePoint& point :
             edgePoints(*patches_[load.trim.face], model_.curve(load.trim.face, load.trim.curve))) {
            scatter(point.side, point.weight * load.force.value(point.side.position, time), force);
        }
    }
}

void DeadLoads::addAtPoints(double time, bool varying, VectorXd& force) const {
    for (const ShellLoads::PointForce& load : loads_.pointForces) {
        if (load.force.dependsOnTime == varying) {
            const PatchLocation place(*patches_[load.face], load.at, Eigen::Vector2d::Zero());
            scatter(place, load.force.value(place.position, time), force);
        }
    }
}

} // namespace tokay::structure
