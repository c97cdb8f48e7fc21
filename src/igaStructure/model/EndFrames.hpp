#pragma once

#include "geometry/NurbsCurve.hpp"
#include "igaStructure/model/LineEnd.hpp"

#include <Eigen/SparseCore>

#include <vector>

namespace tokay::structure {

/// Unknowns of a line whose ends may not turn. The tangent at an end runs along
/// its first two control points, so the end keeps its direction if and only if
/// the second one moves with the first across the tangent, however large the
/// motion. Where a rotation is held the second control point's unknowns are
/// therefore its displacement along the reference tangent, and across it
/// relative to the first control point: the latter is then zero.
class EndFrames {
  public:
    /// @throws InputError if two held ends share a control point
    EndFrames(const geometry::NurbsCurve& curve, const std::vector<LineSupport>& supports);

    /// Unknowns that supports hold, 2 nControlPoints.
    const std::vector<bool>& fixed() const { return fixed_; }

    /// @param unknowns  2 nControlPoints
    /// @return          displacements of control points along x and y
    Eigen::VectorXd displacements(const Eigen::VectorXd& unknowns) const;

    /// The transpose: forces on unknowns.
    Eigen::VectorXd forces(const Eigen::VectorXd& onControlPoints) const;

    /// A matrix for control points becomes one for unknowns.
    Eigen::SparseMatrix<double> matrix(const Eigen::SparseMatrix<double>& ofControlPoints) const;

    /// Rigid motions (along x, along y, rotation) at what is held, one row each;
    /// lengths relative to the line's size.
    Eigen::MatrixX3d heldMotions() const { return heldMotions_; }

  private:
    void hold(const geometry::NurbsCurve& curve, const LineSupport& support);

    bool isIdentity_ = true;
    std::vector<bool> fixed_;
    Eigen::SparseMatrix<double> toDisplacements_;
    Eigen::MatrixX3d heldMotions_;
};

} // namespace tokay::structure
