// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::mapper {

/// What functions show of themselves on an edge, and what they can do unseen.
///
/// On a trimmed edge there are more functions than their traces have dimensions: M_DD is
/// singular, and a motion of the edge leaves some of the control values open. Whoever
/// chooses them (least norm, no slope across the edge) errs by the slope that the body
/// wants. Here they stay unknowns of the body: control values are u = B (a, g), with an
/// orthogonal B whose first rank() columns carry the trace, coefficients a, and whose
/// others, g, vanish on the edge. So a motion of the edge prescribes a, equilibrium decides
/// on g, and forces on the control values act along a alone: their sum, moment and work are
/// those of tractions on the edge.
///
/// The singular values of sqrt(W) N are the roots of the eigenvalues of M_DD = N^T W N,
/// which keeps twice the digits.
class EdgeTrace {
  public:
    /// @param values   N at the points of an edge, nPoints x n
    /// @param weights  W: the length that each point stands for [m]
    EdgeTrace(const Eigen::MatrixXd& values, const Eigen::VectorXd& weights);

    int rank() const { return static_cast<int>(singularValues_.size()); }
    bool isSingular() const { return rank() < basis_.rows(); }

    /// B, n x n, orthogonal: the identity if the trace determines all values.
    const Eigen::MatrixXd& basis() const { return basis_; }

    /// Largest over smallest eigenvalue of M_DD that is not zero.
    double conditionOnRange() const;

    /// Coefficients of the L2 projection onto the traces.
    /// @param atPoints  nPoints x m
    /// @return          rank x m
    Eigen::MatrixXd coefficients(const Eigen::MatrixXd& atPoints) const;

    /// Its transpose: the forces at the points that do the same work.
    /// @param onCoefficients  rank x m [N]
    /// @return                nPoints x m [N]
    Eigen::MatrixXd forcesAtPoints(const Eigen::MatrixXd& onCoefficients) const;

  private:
    Eigen::VectorXd singularValues_; ///< those that are not zero
    Eigen::MatrixXd basis_;
    Eigen::MatrixXd projection_; ///< rank x nPoints
};

} // namespace tokay::mapper
