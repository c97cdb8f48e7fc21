#pragma once

#include "coupling/messages.hpp"
#include "igaStructure/caseFile/Case.hpp"
#include "igaStructure/model/PlaneSolid.hpp"
#include "mapper/NearestElementMapping.hpp"
#include "mapper/SplineInterface.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// The structure's wet edges and their transfer to and from the fluid's
/// interface: displacements to its points, forces from its faces.
class WetBoundary {
  public:
    /// @throws InputError if the two sides do not fit: dimension, gap
    WetBoundary(const PlaneSolid& solid, const Coupling& coupling,
                const coupling::Interface& fluid);

    int nPoints() const { return static_cast<int>(points_.rows()); }
    int nFaces() const { return static_cast<int>(faceCentres_.rows()); }

    /// Displacements of the fluid's points, 2 nPoints [m].
    Eigen::VectorXd displacements(const Eigen::VectorXd& ofUnknowns) const;

    /// Forces on the structure's unknowns; same sum and virtual work.
    /// @param onFaces  2 nFaces, per unit depth [N/m]
    /// @return  on the structure's whole thickness [N]
    /// @throws  coupling::PeerError that names the face whose force is not finite
    Eigen::VectorXd forces(const std::vector<double>& onFaces) const;

    /// Both mappings' reports.
    std::string report() const;

  private:
    double thickness_;
    geometry::Points points_;
    geometry::Points faceCentres_;
    mapper::SplineInterface spline_;
    mapper::NearestElementMapping toPoints_;
    mapper::NearestElementMapping toFaces_;
};

} // namespace tokay::structure
