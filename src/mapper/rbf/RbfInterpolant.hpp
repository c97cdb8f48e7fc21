// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/BoxTree.hpp"
#include "mapper/Discretisation.hpp"
#include "mapper/rbf/RadialKernel.hpp"

#include <memory>

namespace tokay::mapper {

/// Interpolation by kernels and linear polynomials between two clouds: solves
/// K c + P b = values, P^T c = 0; the mapped values are E c + Q b, with kernels E
/// and polynomials Q at the destination.
class RbfInterpolant {
  public:
    virtual ~RbfInterpolant() = default;
    /// @return E c + Q b
    virtual Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const = 0;
    virtual Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const = 0;
    virtual double bytes() const = 0;
};

/// Interpolant by one dense system, for any kernel.
/// @param scale  of the kernel's argument [m]
std::unique_ptr<RbfInterpolant> denseInterpolant(const Points& from, const Points& to,
                                                 RadialKernel kernel, double scale);

/// Interpolant by one sparse system, for compact kernels.
/// @param tree  over the source's points
/// @throws SolverError if the kernels' matrix is not positive definite to rounding
std::unique_ptr<RbfInterpolant> sparseInterpolant(const Points& from, const Points& to,
                                                  const geometry::BoxTree& tree,
                                                  RadialKernel kernel, double radius);

/// Partition of unity: overlapping balls with a small dense interpolation each,
/// blended by smooth weights. Before it a linear polynomial is fitted to all values and
/// taken off, so that linear fields are exact on any cloud.
/// @param tree       over the source's points
/// @param nPerBall   source points of a ball
/// @param radius     of a compact kernel [m]; 0: twice that of the ball
/// Source: Wendland, Scattered Data Approximation, chapter 15.4
std::unique_ptr<RbfInterpolant> partitionInterpolant(const Points& from, const Points& to,
                                                     const geometry::BoxTree& tree,
                                                     RadialKernel kernel, int nPerBall,
                                                     double radius);

/// Boxes of no extent, for a tree over points.
std::vector<geometry::Box> pointBoxes(const Points& points);

/// Matrix of kernels of the distances between two clouds, at.rows() x centres.rows().
Eigen::MatrixXd kernelMatrix(const Points& at, const Points& centres, RadialKernel kernel,
                             double scale);

} // namespace tokay::mapper
