// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsVolume.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::structure {

/// Quadrature points of a side of a volume, element after element.
class SidePoints {
  public:
    /// More points than the basis needs, because formulas need not be polynomials.
    SidePoints(const geometry::NurbsVolume& volume, geometry::Side side);

    struct SidePoint {
        Eigen::Vector3d position;
        double weight; ///< of the parameters' area
        Eigen::Vector3d tangentXi, tangentEta;
        Eigen::MatrixXd N; ///< rows value, by xi, by eta; a column a control point
    };
    struct SideElement {
        std::vector<int> controlPoints; ///< of the volume
        std::vector<SidePoint> points;
    };
    const std::vector<SideElement>& elements() const { return elements_; }

    /// 1 if tangentXi x tangentEta points out of the volume, else -1.
    double outwards() const { return outwards_; }

  private:
    std::vector<SideElement> elements_;
    double outwards_;
};

} // namespace tokay::structure
