// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/SurfaceFunctions.hpp"
#include "igaStructure/kinematics/shell/element/shellStrain.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

class ShellPatch;

/// Goes through the elements of shell patches and their quadrature points.
class ShellElement {
  public:
    using Coefficients = SurfaceFunctions::Coefficients;

    /// The patch is borrowed.
    void moveTo(const ShellPatch& patch, int i, int j);

    const ShellPatch& patch() const { return *patch_; }
    /// Node of each function; two functions may share one (at a pole).
    const std::vector<int>& nodes() const { return nodes_; }
    int nFunctions() const { return static_cast<int>(nodes_.size()); }
    /// Number of quadrature points; none in an empty element.
    int nPoints() const { return nPoints_; }

    void moveToPoint(int point);
    /// Moves to any location of the element or its rim; area() then is not defined.
    void moveToPlace(const Eigen::Vector2d& parameters);

    const SurfaceFunctions& functions() const { return *functions_; }
    const SurfacePoint& reference() const { return *reference_; }
    Eigen::Vector3d position() const { return functions_->value(coordinates_); }
    /// Quadrature weight times reference area [m^2].
    double area() const { return area_; }

    /// Columns of a vector with three entries a node that belong to the functions.
    void gather(const Eigen::VectorXd& values, Coefficients& local) const;
    void scatter(const Coefficients& local, Eigen::VectorXd& values) const;

  private:
    const ShellPatch* patch_ = nullptr;
    int i_ = 0, j_ = 0;
    int nPoints_ = 0;
    bool isCut_ = false;
    std::vector<int> nodes_;
    Coefficients coordinates_;
    Eigen::VectorXd weights_;
    std::optional<SurfaceFunctions> functions_;
    std::optional<SurfacePoint> reference_;
    double area_ = 0;
};

} // namespace tokay::structure
