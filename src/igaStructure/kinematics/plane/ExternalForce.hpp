// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/plane/Loads.hpp"
#include "igaStructure/kinematics/plane/PlaneMaterial.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// Forces on control points that are equivalent to the loads of a plane patch
/// (same virtual work). Loads that do not depend on time are integrated once.
class ExternalForce {
  public:
    ExternalForce(geometry::NurbsSurface surface, const PlaneMaterial& material, Loads loads);

    /// @return  2 nControlPoints [N]
    /// @throws  InputError if a formula's value is not finite
    const Eigen::VectorXd& at(double time);

  private:
    void add(const SideTraction& load, double time, Eigen::VectorXd& force) const;
    void add(const Gravity& load, double time, Eigen::VectorXd& force) const;

    geometry::NurbsSurface surface_;
    PlaneMaterial material_;
    Loads varying_; ///< with time
    Eigen::VectorXd constant_;
    Eigen::VectorXd force_;
};

} // namespace tokay::structure
