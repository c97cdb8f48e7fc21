// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/InterfaceTransfer.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/offset/OffsetMapping.hpp"

namespace tokay::structure {

/// Transfer between a shell and fluids on one or both of its sides: points move with
/// the section of the shell at which they lie.
class ShellTransfer : public InterfaceTransfer {
  public:
    /// The shell is borrowed.
    /// @throws InputError if a point is too far from the middle surface
    ShellTransfer(const Shell& shell, const Coupling& coupling, const geometry::Points& points);

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
    bool isLinear_;
    mapper::SurfaceInterface middle_;
    mapper::OffsetMapping toPoints_;
};

} // namespace tokay::structure
