// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/InterfaceTransfer.hpp"
#include "igaStructure/kinematics/beam/Line.hpp"
#include "mapper/offset/OffsetMapping.hpp"

namespace tokay::structure {

/// Transfer between a beam or cable in the plane and the fluid around it: points move with
/// the section at which they lie, both sides and the ends.
class LineTransfer : public InterfaceTransfer {
  public:
    /// @param line  is kept by reference
    /// @throws InputError if a point is farther from the axis than the gap limit
    LineTransfer(const Line& line, const Coupling& coupling, const geometry::Points& points);

    geometry::Points displacements(const Eigen::VectorXd& displacement) const override;
    geometry::Points variation(const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& variation) const override;
    Eigen::VectorXd forces(const Eigen::VectorXd& displacement,
                           const geometry::Points& onPoints) const override;
    geometry::Points controlForces(const Eigen::VectorXd& displacement,
                                   const geometry::Points& onPoints) const override;
    geometry::Points controlPoints(const Eigen::VectorXd& displacement) const override;
    double depth() const override { return line_.section().width; }
    std::string report() const override;

  private:
    geometry::Points ofControlPoints(const Eigen::VectorXd& displacement) const;

    const Line& line_;
    mapper::SplineInterface axis_;
    mapper::OffsetMapping toPoints_;
};

} // namespace tokay::structure
