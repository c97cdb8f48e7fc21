// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"
#include "igaStructure/coupledRun/InterfaceFaces.hpp"
#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/kinematics/Coupling.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// The fluid's interface as the structure sees it: transfers forces on its faces and
/// displacements of its points to and from the body.
class WetBoundary {
  public:
    /// @throws InputError if the two sides do not fit: dimension, gap
    WetBoundary(const Body& body, const Coupling& coupling, const channel::Interface& fluid);

    int dimension() const { return dimension_; }
    int nPoints() const { return static_cast<int>(points().rows()); }
    int nFaces() const { return faces_.count(); }
    /// Whether it is the edge of another structure, whose faces are points.
    bool isEdge() const { return faces_.mesh().hasOnlyPoints(); }
    /// Of displacements(): dimension times nPoints().
    int nComponents() const { return dimension_ * nPoints(); }

    /// Points of the fluid in the reference configuration, nPoints x 3 [m]
    const geometry::Points& points() const { return faces_.mesh().vertices; }

    /// Displacements of the fluid's points, point after point [m].
    Eigen::VectorXd displacements(const Eigen::VectorXd& displacement) const;

    /// Derivative of displacements() at a displacement along variations, a
    /// column each.
    Eigen::MatrixXd variations(const Eigen::VectorXd& displacement,
                               const Eigen::MatrixXd& variations) const;

    /// Forces on the structure's unknowns; same sum.
    /// @param faceForces    face after face [N]; a plane scene: per unit depth [N/m]
    /// @param displacement  of the structure, at which a thin body's sections stand
    Eigen::VectorXd forces(const Eigen::VectorXd& faceForces,
                           const Eigen::VectorXd& displacement) const;

    /// Forces on faces, nFaces x 3, of the argument of forces().
    geometry::Points onFaces(const Eigen::VectorXd& faceForces) const;

    /// Centroid of a face in the reference configuration [m].
    Eigen::VectorXd faceCentre(int face) const;

    const InterfaceFaces& faces() const { return faces_; }
    const InterfaceTransfer& transfer() const { return *transfer_; }

    /// The mapping's report.
    std::string report() const { return transfer_->report(); }

  private:
    Eigen::VectorXd components(const geometry::Points& ofPoints) const;

    int dimension_;
    InterfaceFaces faces_;
    std::unique_ptr<InterfaceTransfer> transfer_;
};

} // namespace tokay::structure
