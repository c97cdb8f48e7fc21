#pragma once

#include "igaStructure/model/shell/ElementSweep.hpp"
#include "igaStructure/model/shell/NodePattern.hpp"
#include "igaStructure/model/shell/ShellConstraints.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// Forces on nodes by the loads of a shell that turn with it: pressure on the
/// current area, and moments about edges.
class FollowerLoads {
  public:
    /// All but the loads is borrowed.
    FollowerLoads(const ShellLoads& loads, const geometry::BrepModel& model,
                  const ShellPatches& patches, const ElementSweep& sweep);

    void addForce(const Eigen::VectorXd& displacement, double time, Eigen::VectorXd& force) const;

    /// Subtracts the symmetric part of the force's derivative from the values of a
    /// matrix made by the pattern. The part left out is that of the loaded area's
    /// rim, zero where the rim is held.
    void subtractDerivative(const Eigen::VectorXd& displacement, double time,
                            const NodePattern& pattern, double* values) const;

  private:
    double pressureAt(const ShellElement& element, double time) const;

    std::vector<ShellLoads::Pressure> pressures_;
    struct Moment {
        ScalarField moment;
        std::vector<EdgePoint> points;
    };
    std::vector<Moment> moments_;
    const ShellPatches& patches_;
    const ElementSweep& sweep_;
};

} // namespace tokay::structure
