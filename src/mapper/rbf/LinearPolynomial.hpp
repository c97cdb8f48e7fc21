// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Discretisation.hpp"

namespace tokay::mapper {

/// The polynomials of degree 1 on a cloud of points: a constant and a coordinate
/// along each axis in which the cloud has an extent, so that they are independent
/// on flat and straight clouds too.
class LinearPolynomial {
  public:
    /// @param leastExtent  of an axis that counts, over the largest. The default:
    /// with less, scaled by the whole extent, an axis would be lost in the rounding
    /// of a kernel's matrix.
    explicit LinearPolynomial(const Points& cloud, double leastExtent = 1e-6);

    /// 1 and the number of axes.
    int size() const { return 1 + static_cast<int>(axes_.rows()); }
    int nAxes() const { return static_cast<int>(axes_.rows()); }

    /// n x size(), coordinates relative to the cloud's extent.
    Eigen::MatrixXd values(const Points& points) const;

  private:
    Point centre_;
    /// Axes, one per row, over the extent of the cloud.
    Eigen::MatrixX3d axes_;
};

} // namespace tokay::mapper
