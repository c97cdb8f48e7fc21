// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/interfaceBalance.hpp"

#include <Eigen/Geometry>

namespace tokay::structure {

using Eigen::Vector3d;
using geometry::Points;

channel::InterfaceBalance interfaceBalance(const WetBoundary& boundary, const AuditedStep& step) {
    const InterfaceTransfer& transfer = boundary.transfer();
    const Points forces = transfer.controlForces(step.mapped, boundary.onFaces(step.forces));
    const Points positions = transfer.controlPoints(step.after);
    Vector3d force = Vector3d::Zero();
    Vector3d moment = Vector3d::Zero();
    for (Eigen::Index i = 0; i < forces.rows(); ++i) {
        const Vector3d f = forces.row(i);
        force += f;
        moment += Vector3d(positions.row(i)).cross(f);
    }
    const double work = transfer.onUnknowns(forces).dot(step.after - step.before);
    const Points& points = boundary.points();
    channel::InterfaceBalance balance;
    balance.force = {force.x(), force.y(), force.z()};
    balance.moment = {moment.x(), moment.y(), moment.z()};
    balance.power = work / transfer.depth() / step.deltaT;
    balance.sweptVolume = boundary.faces().sweptVolume(points + transfer.displacements(step.before),
                                                       points + transfer.displacements(step.after));
    return balance;
}

} // namespace tokay::structure
