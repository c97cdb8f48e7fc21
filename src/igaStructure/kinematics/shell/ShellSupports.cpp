// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/ShellSupports.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

using Eigen::VectorXd;

ShellSupports::ShellSupports(const ShellDescription& description, const ShellPatches& patches,
                             const ShellNodes& nodes)
    : description_(description), nodes_(nodes),
      constraints_(shellConstraints(description, patches, nodes.count())) {
    if (constraints_.trimmedSupports.empty()) {
        return;
    }
    extension_ = std::make_unique<DirichletExtension>(
        description_, patches, constraints_.trimmedSupports, constraints_.fixed);
    for (const int unknown : extension_->dependents()) {
        constraints_.fixed[unknown] = true;
    }
    for (const TracePoint& point : extension_->trace()) {
        extension_->own(point, constraints_.owners);
    }
    lastIterate_ = VectorXd::Zero(3 * nodes_.count());
}

VectorXd ShellSupports::prescribed(double time) const {
    VectorXd values = constraints_.trace.isEmpty() ? VectorXd(VectorXd::Zero(3 * nodes_.count()))
                                                   : constraints_.trace.at(time);
    if (extension_) {
        values += extension_->values(time, extension_->isClosed() ? values : lastIterate_);
    }
    return values;
}

bool ShellSupports::settle(const VectorXd& displacement) {
    if (!extension_ || extension_->isClosed()) {
        return true;
    }
    const double change = (displacement - lastIterate_).norm();
    const double size = lastIterate_.norm();
    lastIterate_ = displacement;
    ++nIterates_;
    if (change <= description_.egm.tolerance * size || change == 0) {
        nIterates_ = 0;
        return true;
    }
    if (nIterates_ >= description_.egm.maxIterations) {
        nIterates_ = 0;
        throw SolverError(fmt::format("the extended gradient method did not converge in {} "
                                      "iterations: its last one changed the displacement by {:.2g} "
                                      "of itself; take egm.form closed, or other elements",
                                      description_.egm.maxIterations, change / size));
    }
    return false;
}

bool ShellSupports::resistInertia(double massFactor) {
    for (const auto& coupling : constraints_.couplings) {
        coupling->resistInertia(massFactor);
    }
    latestShifts_ = {};
    return !constraints_.couplings.empty();
}

// Of each coupling, those that no support moves included.
const std::vector<EdgeCoupling::Shift>& ShellSupports::couplingShifts(double time) const {
    return latestShifts_.at(time, [&] {
        std::vector<EdgeCoupling::Shift> shifts(constraints_.couplings.size());
        for (const auto& [coupling, motion] : constraints_.moved) {
            shifts[coupling] = constraints_.couplings[coupling]->shift(*motion, time);
        }
        return shifts;
    });
}

StructuralModel::SupportShift ShellSupports::shift(double time) const {
    StructuralModel::SupportShift sum;
    if (constraints_.moved.empty()) {
        return sum;
    }
    sum.force = VectorXd::Zero(3 * nodes_.count());
    const std::vector<EdgeCoupling::Shift>& shifts = couplingShifts(time);
    for (const ShellConstraints::Moved& moved : constraints_.moved) {
        const EdgeCoupling::Shift& own = shifts[moved.coupling];
        const std::vector<int>& nodes = constraints_.couplings[moved.coupling]->nodes();
        for (std::size_t k = 0; own.force.size() > 0 && k < nodes.size(); ++k) {
            sum.force.segment<3>(3 * nodes[k]) +=
                own.force.segment<3>(3 * static_cast<Eigen::Index>(k));
        }
        sum.energy += own.energy;
        sum.largest = std::max(sum.largest, own.largest);
    }
    return sum;
}

std::vector<std::string> ShellSupports::names() const {
    std::vector<std::string> names;
    for (const EdgeSupport& support : description_.edgeSupports) {
        names.push_back(support.name);
    }
    for (const PointSupport& support : description_.pointSupports) {
        names.push_back(support.name);
    }
    return names;
}

std::vector<SupportLoad> ShellSupports::loads(const VectorXd& displacement,
                                              const VectorXd& reaction, double time) const {
    std::vector<SupportLoad> loads(description_.edgeSupports.size() +
                                   description_.pointSupports.size());
    const geometry::Points positions = description_.strains == Strains::linear
                                           ? nodes_.positions
                                           : moved(nodes_.positions, 3, displacement);
    addForces(constraints_.owners, positions, 3, reaction, loads);
    const std::vector<EdgeCoupling::Shift>& shifts = couplingShifts(time);
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        if (constraints_.couplingOwners[k] < 0) {
            continue;
        }
        const EdgeCoupling& coupling = *constraints_.couplings[k];
        VectorXd force = coupling.answer(displacement, description_.strains, false).force;
        force += shifts[k].force.size() > 0 ? shifts[k].force : VectorXd::Zero(force.size());
        for (std::size_t node = 0; node < coupling.nodes().size(); ++node) {
            loads[constraints_.couplingOwners[k]].add(
                positions.row(coupling.nodes()[node]),
                -force.segment<3>(3 * static_cast<Eigen::Index>(node)));
        }
    }
    return loads;
}

} // namespace tokay::structure
