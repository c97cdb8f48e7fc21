// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <Eigen/Core>

#include <string>

namespace tokay::structure {

/// Transfer between a body and the points of a fluid's interface.
class InterfaceTransfer {
  public:
    virtual ~InterfaceTransfer() = default;

    /// @param displacement  of the body's unknowns
    /// @return              of the fluid's points, nPoints x 3 [m]
    virtual geometry::Points displacements(const Eigen::VectorXd& displacement) const = 0;

    /// Derivative of displacements() at a displacement along a variation.
    virtual geometry::Points variation(const Eigen::VectorXd& displacement,
                                       const Eigen::VectorXd& variation) const = 0;

    /// The transpose of the derivative of displacements() at a state, so that
    /// virtual work is kept.
    /// @param onPoints  nPoints x 3 [N]; a plane scene: per unit depth [N/m]
    /// @return          on the body's unknowns, a plane body's whole depth [N]
    virtual Eigen::VectorXd forces(const Eigen::VectorXd& displacement,
                                   const geometry::Points& onPoints) const = 0;

    /// The same as forces of the control points, n x 3, per unit depth as given.
    virtual geometry::Points controlForces(const Eigen::VectorXd& displacement,
                                           const geometry::Points& onPoints) const = 0;

    /// Where the control points are at a displacement, n x 3 [m]
    virtual geometry::Points controlPoints(const Eigen::VectorXd& displacement) const = 0;

    /// Of a plane body [m]; 1 in space.
    virtual double depth() const { return 1; }

    /// What the mapping found, for a person.
    virtual std::string report() const = 0;
};

} // namespace tokay::structure
