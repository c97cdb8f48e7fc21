// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/Mapping.hpp"
#include "mapper/rbf/RadialKernel.hpp"
#include "mapper/rbf/RbfInterpolant.hpp"

#include <memory>

namespace tokay::mapper {

/// Solution method of the interpolation.
enum class RbfSolution {
    automatic,       ///< see chosenSolution
    global,          ///< one system: dense, or with ever smaller kernels
    partitionOfUnity ///< many small systems, blended: time and memory grow with the points
};

struct RbfOptions {
    RadialKernel kernel = RadialKernel::thinPlate;
    RbfSolution solution = RbfSolution::automatic;
    /// Source points of a ball of the partition of unity.
    int nPerBall = 60;
    /// Radius of the compact kernels [m]; 0: for the partition of unity twice that of a ball;
    /// globally so large that every point has about nNeighbours others within it. That
    /// keeps the matrix sparse, but the error then stops falling once the spacing is fine: the
    /// kernels shrink with it.
    double radius = 0;
    /// 0: 12 on curves, 40 on surfaces, 80 in space.
    int nNeighbours = 0;
    /// Distance to the nearest source point, over the size of the interface.
    GapLimit gapLimit{0.1, true};
};

/// Solution method that `automatic` selects. The thin plate is solved globally up to 300 source
/// points, within the bound of memory: with more of them the partition of unity is at least as
/// accurate and takes less memory, whatever the number of destination points
/// (measured by benchmarks/mapping/run). Compact kernels are solved globally only if
/// their number of neighbours is given: with a radius or without one the partition of
/// unity is more accurate and quicker at any size.
RbfSolution chosenSolution(const RbfOptions& options, Eigen::Index nFrom, Eigen::Index nTo);

/// Interpolation by radial basis functions and linear polynomials: it needs no
/// mesh, takes linear fields exactly, and passes through the source's values.
class RbfMapping : public Mapping {
  public:
    /// Most source points of the thin plate kernel solved globally (its system is dense),
    /// and most memory of its values at the destination, nTo x nFrom.
    static constexpr int maxDensePoints = 8000;
    static constexpr double maxDenseBytes = 1e9;

    /// @param from  source points, nFrom x 3 [m]
    /// @param to    destination points, nTo x 3 [m]
    /// @throws InputError for coinciding source points, too many points on either side
    /// for a dense kernel solved globally, a point far from all source points
    RbfMapping(const Points& from, const Points& to, const RbfOptions& options = {});
    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override;
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override;

    /// Radius of the compact kernel [m]; 0 for the thin plate, and where it follows the balls
    /// of the partition of unity.
    double radius() const { return radius_; }

  private:
    double radius_ = 0;
    std::unique_ptr<RbfInterpolant> interpolant_;
};

} // namespace tokay::mapper
