// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"
#include "igaStructure/kinematics/shell/element/ElementRows.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// Forces on nodes by the loads of a shell that keep their direction: tractions,
/// gravity, line and point forces. What does not depend on time is integrated once.
class DeadLoads {
  public:
    /// Patches, sweep and model are borrowed.
    DeadLoads(const ShellLoads& loads, const geometry::BrepModel& model,
              const ShellPatches& patches, const ElementRows& sweep, int nUnknowns);

    /// @return  nUnknowns [N]
    const Eigen::VectorXd& at(double time);

  private:
    /// Area loads of one patch: tractions and gravity, as force per area.
    Eigen::Vector3d areaLoad(int face, const geometry::Point& place, double time,
                             bool varying) const;
    bool hasAreaLoads(bool varying) const;
    void add(double time, bool varying, Eigen::VectorXd& force) const;
    void addOnAreas(double time, bool varying, Eigen::VectorXd& force) const;
    void addOnEdges(double time, bool varying, Eigen::VectorXd& force) const;
    void addAtPoints(double time, bool varying, Eigen::VectorXd& force) const;

    ShellLoads loads_;
    const geometry::BrepModel& model_;
    const ShellPatches& patches_;
    const ElementRows& sweep_;
    Eigen::VectorXd constant_;
    Eigen::VectorXd force_;
};

} // namespace tokay::structure
