// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/NodePattern.hpp"
#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"
#include "igaStructure/kinematics/shell/element/ElementRows.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// Forces on nodes by the loads of a shell that turn with it: pressure on the
/// current area, and moments about edges.
class FollowerLoads {
  public:
    /// All but the loads is borrowed.
    FollowerLoads(const ShellLoads& loads, const geometry::BrepModel& model,
                  const ShellPatches& patches, const ElementRows& sweep);

    void addForce(const Eigen::VectorXd& displacement, double time, Eigen::VectorXd& force) const;

    /// Subtracts the force's derivative, which need not be symmetric, from the values
    /// of a matrix made by the pattern.
    void subtractDerivative(const Eigen::VectorXd& displacement, double time,
                            const NodePattern& pattern, double* values) const;

  private:
    enum class Wanted { force, derivative };
    /// On some nodes, three components each.
    struct Answer {
        Eigen::VectorXd force;
        Eigen::MatrixXd derivative;
    };
    struct Moment {
        ScalarField moment;
        std::vector<EdgePoint> points;
    };
    /// Calls use(nodes, answer) for each loaded element and point of an edge.
    template <class Use>
    void forEachAnswer(const Eigen::VectorXd& displacement, double time, Wanted wanted,
                       Use use) const;
    double pressureAt(const ShellElement& element, double time) const;
    Answer pressureOn(ShellElement& element, const Eigen::VectorXd& displacement, double time,
                      Wanted wanted) const;
    static Answer momentAt(const EdgePoint& point, double moment,
                           const Eigen::VectorXd& displacement, Wanted wanted);

    std::vector<ShellLoads::Pressure> pressures_;
    std::vector<Moment> moments_;
    const ShellPatches& patches_;
    const ElementRows& sweep_;
};

} // namespace tokay::structure
