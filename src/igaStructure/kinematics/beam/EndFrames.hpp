// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "igaStructure/assembly/RigidMotions.hpp"
#include "igaStructure/assembly/SparseMatrix.hpp"
#include "igaStructure/assembly/SupportLoad.hpp"
#include "igaStructure/kinematics/beam/BeamDescription.hpp"

#include <vector>

namespace tokay::structure {

/// Unknowns of a beam whose ends may not turn. The tangent at an end runs along
/// its first two control points, so the end keeps its direction if and only if
/// the second one moves with the first across the tangent, however large the
/// motion. Where a rotation is held the second control point's unknowns are
/// therefore its displacement along the reference tangent, and across it (in
/// space along two normals) relative to the first control point: these are then
/// zero, also where the end moves.
class EndFrames {
  public:
    /// @param dimension  2 or 3: unknowns a control point
    /// @throws InputError if two held ends share a control point
    EndFrames(const geometry::NurbsCurve& curve, const std::vector<BeamSupport>& supports,
              int dimension);

    /// Unknowns that supports hold, dimension nControlPoints.
    const std::vector<bool>& fixed() const { return fixed_; }

    /// Motion of the unknowns of ends that move.
    const SupportTrace& trace() const { return trace_; }

    /// @param unknowns  dimension nControlPoints
    /// @return          displacements of control points along x, y and in space z
    Eigen::VectorXd displacements(const Eigen::VectorXd& unknowns) const;

    /// Forces on control points that are these forces on unknowns, the inverse of forces().
    Eigen::VectorXd onControlPoints(const Eigen::VectorXd& onUnknowns) const;

    /// The number of the support that holds each unknown.
    const SupportOwners& owners() const { return owners_; }

    /// The transpose: forces on unknowns.
    Eigen::VectorXd forces(const Eigen::VectorXd& onControlPoints) const;

    /// A matrix for control points becomes one for unknowns.
    SparseMatrix matrix(const SparseMatrix& ofControlPoints) const;

    /// Rigid motions that what is held leaves free, in words. In space turning about
    /// its chord does not count as one.
    std::vector<std::string> freeRigidMotions() const { return motions_.freeOnes(); }

  private:
    void holdWhatIsNoMotion(const geometry::NurbsCurve& curve);
    void hold(const geometry::NurbsCurve& curve, const BeamSupport& support);
    std::vector<bool> heldBy(const BeamSupport& support) const;
    SupportTrace traceOf(const geometry::NurbsCurve& curve,
                         const std::vector<BeamSupport>& supports) const;
    void holdRotation(int first, int second, const Eigen::Vector3d& tangent);

    int dimension_;
    bool isIdentity_ = true;
    std::vector<bool> fixed_;
    SparseMatrix toDisplacements_;
    SparseMatrix toUnknowns_; ///< its inverse
    RigidMotions motions_;
    SupportTrace trace_;
    SupportOwners owners_;
};

} // namespace tokay::structure
