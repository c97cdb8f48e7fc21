// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsVolume.hpp"
#include "igaStructure/assembly/PatchNodes.hpp"
#include "igaStructure/assembly/TabulatedBasis.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace tokay::structure {

/// A volume with its functions at the Gauss points of every direction.
struct SolidGrid {
    /// @param nodes             of the control points
    /// @param additionalPoints  per direction, beyond degree + 1
    SolidGrid(const geometry::NurbsVolume& volume, const PatchNodes& nodes,
              int additionalPoints = 0);

    int nElements() const { return basis[0].nSpans() * basis[1].nSpans() * basis[2].nSpans(); }
    int nFunctions() const;
    int nPointsPerElement() const;

    const geometry::NurbsVolume& volume; ///< borrowed
    const PatchNodes& nodes;             ///< borrowed
    std::array<TabulatedBasis, 3> basis;
};

/// The functions of a volume on one element (box of knot spans), at one quadrature
/// point after the other, with their gradients in the reference configuration.
class SolidElement {
  public:
    /// One row a direction of space.
    using Gradients = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
    using Coefficients = Eigen::Matrix<double, 3, Eigen::Dynamic>;

    /// The grid is borrowed.
    explicit SolidElement(const SolidGrid& grid);

    int nFunctions() const { return static_cast<int>(nodes_.size()); }
    int nPoints() const { return grid_->nPointsPerElement(); }

    void moveToElement(const Eigen::Vector3i& spans);
    void moveToPoint(int point);

    /// Node of each function.
    const std::vector<int>& nodes() const { return nodes_; }
    const Eigen::VectorXd& values() const { return values_; }
    /// Column a: gradient of function a [1/m].
    const Gradients& gradients() const { return gradients_; }
    Eigen::Vector3d position() const { return coordinates_ * values_; }
    /// Quadrature weight times volume element [m^3].
    double volume() const { return volume_; }

    /// Columns of a vector with three entries per node that belong to the functions.
    void gather(const Eigen::VectorXd& values, Coefficients& local) const;
    void scatter(const Coefficients& local, Eigen::VectorXd& values) const;

    /// @throws InputError if the volume is turned inside out at the point
    void requireRegular() const;

  private:
    void setProducts(const std::array<const Eigen::MatrixXd*, 3>& N);
    void makeRational();

    const SolidGrid* grid_;
    Eigen::Vector3i spans_ = Eigen::Vector3i::Zero();
    std::vector<int> nodes_;
    Coefficients coordinates_;
    Eigen::VectorXd weights_;
    Eigen::VectorXd values_;
    Gradients derivatives_; ///< by the parameters
    Gradients gradients_;
    double volume_ = 0;
};

} // namespace tokay::structure
