#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/Mapping.hpp"
#include "mapper/RadialKernel.hpp"
#include "mapper/RbfInterpolant.hpp"
#include <memory>

namespace tokay::mapper {

/// How the interpolation is solved.
enum class RbfSolution {
    automatic,       ///< global for small clouds, else partition of unity
    global,          ///< one system: smoothest, but dense, or with ever smaller kernels
    partitionOfUnity ///< many small systems, blended: time and memory grow with the points
};

struct RbfOptions {
    RadialKernel kernel = RadialKernel::thinPlate;
    /// Most points that automatic solves globally: some seconds each.
    static constexpr int mostDensePoints = 2000, mostSparsePoints = 20000;
    RbfSolution solution = RbfSolution::automatic;
    /// Source points of a ball of the partition of unity.
    int nPerBall = 60;
    /// Of the compact kernels, solved globally [m]; 0: so large that every point has about
    /// nNeighbours others within it. That keeps the matrix sparse, but the error
    /// then stops falling once the spacing is fine: the kernels shrink with it.
    double radius = 0;
    /// 0: 12 on curves, 40 on surfaces, 80 in space.
    int nNeighbours = 0;
    /// Distance to the nearest source point, over the size of the interface.
    GapLimit gapLimit{0.1, true};
};

/// Interpolation by radial basis functions and linear polynomials: it needs no
/// mesh, takes linear fields exactly, and passes through the source's values.
class RbfMapping : public Mapping {
  public:
    /// Most points of the thin plate kernel solved globally: its matrix is dense.
    static constexpr int maxDensePoints = 8000;

    /// @param from  source points, nFrom x 3 [m]
    /// @param to    destination points, nTo x 3 [m]
    /// @throws InputError for coinciding source points, too many points for a
    /// dense kernel solved globally, a point far from all source points
    RbfMapping(const Points& from, const Points& to, const RbfOptions& options = {});
    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override;
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override;

    /// Of the compact kernel [m]; 0 for the thin plate and the partition of unity.
    double radius() const { return radius_; }

  private:
    double radius_ = 0;
    std::unique_ptr<RbfInterpolant> interpolant_;
};

} // namespace tokay::mapper
