// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/NodePattern.hpp"
#include "igaStructure/assembly/PatchNodes.hpp"
#include "igaStructure/kinematics/solid/SolidDescription.hpp"

#include <Eigen/Core>

#include <memory>

namespace tokay::structure {

class SidePoints;

/// Forces on the control points of a solid by its loads (same virtual work). Loads
/// that depend neither on time nor on the displacement are integrated once.
class SolidLoading {
  public:
    explicit SolidLoading(const SolidDescription& description);
    ~SolidLoading();

    /// Forces of tractions and gravity [N].
    /// @throws InputError if a formula's value is not finite
    Eigen::VectorXd deadForce(double time) const;

    /// Forces of the pressures, on the current area [N].
    /// @param displacement  of the control points
    Eigen::VectorXd pressure(const Eigen::VectorXd& displacement, double time) const;

    /// Subtracts the pressures' derivative, which need not be symmetric, from the
    /// values of a matrix made by the pattern of the nodes.
    void subtractPressureDerivative(const Eigen::VectorXd& displacement, double time,
                                    const PatchNodes& nodes, const NodePattern& pattern,
                                    double* values) const;

  private:
    void addDead(double time, bool varying, Eigen::VectorXd& force) const;
    void addGravity(const VectorField& gravity, double time, Eigen::VectorXd& force) const;

    geometry::NurbsVolume volume_;
    double density_;
    SolidLoads loads_;
    std::vector<std::unique_ptr<SidePoints>> sides_; ///< empty where nothing acts
    Eigen::VectorXd constant_;
};

} // namespace tokay::structure
