// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/Coupling.hpp"
#include "mapper/GapStatistics.hpp"
#include "mapper/Mapping.hpp"
#include "mapper/interface/SplineInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/loads/FaceSizes.hpp"

#include <memory>
#include <string>
#include <variant>

namespace tokay::structure {

/// The wet part of a body. Its values are those of the control points of the whole
/// body, which is what the unknowns of a StructuralModel are.
using WetSurface = std::variant<mapper::SplineInterface, mapper::SurfaceInterface>;

/// Maps displacements of a body's control points to the fluid's points.
/// @param to        faces of the fluid's interface
/// @param isLinear  whether the body has linear strains: its sections then turn
///                  by small angles only
/// @throws InputError if a gap is beyond a limit that refuses, or for points that a
///         mortar mapping does not reach
std::unique_ptr<const mapper::Mapping> makeMapping(TransferMethod method, const WetSurface& from,
                                                   const mapper::FaceMesh& to,
                                                   const mapper::GapLimit& limit, bool isLinear);

/// Where forces on faces act, and the mapping whose transpose takes them from there to
/// the control points.
struct LoadMapping {
    mapper::LoadPoints at;
    std::unique_ptr<const mapper::Mapping> mapping; ///< none: that of displacements
    bool loadsPoints = false; ///< spans between the points that it loads get nothing
};

/// Loads by integration over the faces, mapped as displacements are by offset or, for
/// every other method, by nearestElement.
LoadMapping makeLoadMapping(const Coupling& coupling, const WetSurface& from,
                            const mapper::FaceMesh& faces, bool isLinear);

/// Transfer between a body and a fluid's interface: the motion of its points by the
/// body's unknowns, its derivative, and forces on its faces as forces on the unknowns.
class InterfaceTransfer {
  public:
    /// @param model          is kept by reference
    /// @param controlPoints  in the reference configuration, n x 3 [m]
    /// @param displacements  from the control points to the fluid's points
    /// @param sizes          of the fluid's faces, for the report; none: they are points
    /// @param depth          of a plane body [m]; 1 in space
    InterfaceTransfer(const StructuralModel& model, geometry::Points controlPoints,
                      std::unique_ptr<const mapper::Mapping> displacements, LoadMapping loads,
                      mapper::FaceSizes sizes, double depth);

    /// Displacements of the fluid's points, nPoints x 3 [m].
    /// @param displacement  of the body's unknowns
    geometry::Points displacements(const Eigen::VectorXd& displacement) const;

    /// Derivative of displacements() at a displacement along a variation.
    geometry::Points variation(const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& variation) const;

    /// Forces on the body's unknowns, a plane body's whole depth [N].
    /// @param displacement  at which the sections of a thin body stand
    /// @param onFaces       nFaces x 3 [N]; a plane scene: per unit depth [N/m]
    Eigen::VectorXd forces(const Eigen::VectorXd& displacement,
                           const geometry::Points& onFaces) const;

    /// The forces of forces() on the control points, n x 3, per unit depth as given.
    geometry::Points controlForces(const Eigen::VectorXd& displacement,
                                   const geometry::Points& onFaces) const;

    /// What forces() are of controlForces().
    Eigen::VectorXd onUnknowns(const geometry::Points& controlForces) const;

    /// Positions of the control points at a displacement, n x 3 [m].
    geometry::Points controlPoints(const Eigen::VectorXd& displacement) const {
        return controlPoints_ + controlDisplacements(displacement);
    }

    /// Depth of a plane body [m]; 1 in space.
    double depth() const { return depth_; }

    /// The mappings' reports and the sizes of both sides, for the log.
    std::string report() const;

  private:
    geometry::Points controlDisplacements(const Eigen::VectorXd& unknowns) const;

    const StructuralModel& model_;
    geometry::Points controlPoints_;
    std::unique_ptr<const mapper::Mapping> displacements_;
    LoadMapping loads_;
    mapper::FaceSizes sizes_;
    double depth_;
};

} // namespace tokay::structure
