// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/InterfaceTransfer.hpp"
#include "igaStructure/kinematics/solid/Solid.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"

namespace tokay::structure {

/// Transfer at the wet sides of a solid: the spline at the closest points.
class SolidTransfer : public InterfaceTransfer {
  public:
    /// @throws InputError if a gap is beyond the limit
    SolidTransfer(const Solid& solid, const Coupling& coupling, const geometry::Points& points);

    geometry::Points displacements(const Eigen::VectorXd& displacement) const override;
    geometry::Points variation(const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& variation) const override;
    Eigen::VectorXd forces(const Eigen::VectorXd& displacement,
                           const geometry::Points& onPoints) const override;
    geometry::Points controlForces(const Eigen::VectorXd& displacement,
                                   const geometry::Points& onPoints) const override;
    geometry::Points controlPoints(const Eigen::VectorXd& displacement) const override;
    std::string report() const override;

  private:
    mapper::SurfaceInterface sides_;
    mapper::NearestElementMapping toPoints_;
};

} // namespace tokay::structure
