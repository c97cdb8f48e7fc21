#pragma once

#include "geometry/Points.hpp"

#include <Eigen/Core>

#include <string>

namespace tokay::structure {

/// Transfer between a body and the points and faces of a fluid's interface.
class InterfaceTransfer {
  public:
    virtual ~InterfaceTransfer() = default;

    /// @param displacement  of the body's unknowns
    /// @return              of the fluid's points, nPoints x 3 [m]
    virtual geometry::Points displacements(const Eigen::VectorXd& displacement) const = 0;

    /// The transpose of the derivative of the motion of the face centres at a
    /// state, so that virtual work is kept.
    /// @param onFaces  nFaces x 3 [N]; a plane scene: per unit depth [N/m]
    /// @return         on the body's unknowns, a plane body's whole depth [N]
    virtual Eigen::VectorXd forces(const Eigen::VectorXd& displacement,
                                   const geometry::Points& onFaces) const = 0;

    /// What the mappings found, for a person.
    virtual std::string report() const = 0;
};

} // namespace tokay::structure
