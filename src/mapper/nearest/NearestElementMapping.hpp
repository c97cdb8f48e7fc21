// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/Mapping.hpp"
#include "mapper/RowSparseMatrix.hpp"

namespace tokay::mapper {

/// Values at points by the functions of the closest element: exact spline
/// evaluation for a spline interface, the nearest value for a point cloud.
/// Points beyond a gap limit that does not refuse take their projection's value
/// all the same.
class NearestElementMapping : public Mapping {
  public:
    /// @param to  destination points, nTo x 3 [m]
    /// @throws InputError that names the worst point, its gap and the limit, if
    /// a point is too far away or not finite.
    NearestElementMapping(const Discretisation& from, const Points& to,
                          const GapLimit& gapLimit = {});

    /// nTo x nValues.
    const RowSparseMatrix& matrix() const { return matrix_; }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override;
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override;

  private:
    RowSparseMatrix matrix_;
};

} // namespace tokay::mapper
