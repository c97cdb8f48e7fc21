// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/InterfaceTransfer.hpp"
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"
#include "mapper/interface/SplineInterface.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"

namespace tokay::structure {

/// Transfer at the wet edges of a plane solid: the spline at the closest points.
class PlaneTransfer : public InterfaceTransfer {
  public:
    /// @throws InputError if a gap is beyond the limit
    PlaneTransfer(const PlaneSolid& solid, const Coupling& coupling,
                  const geometry::Points& points);

    geometry::Points displacements(const Eigen::VectorXd& displacement) const override;
    geometry::Points variation(const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& variation) const override;
    Eigen::VectorXd forces(const Eigen::VectorXd& displacement,
                           const geometry::Points& onPoints) const override;
    geometry::Points controlForces(const Eigen::VectorXd& displacement,
                                   const geometry::Points& onPoints) const override;
    geometry::Points controlPoints(const Eigen::VectorXd& displacement) const override;
    double depth() const override { return thickness_; }
    std::string report() const override;

  private:
    double thickness_;
    mapper::SplineInterface spline_;
    mapper::NearestElementMapping toPoints_;
};

} // namespace tokay::structure
