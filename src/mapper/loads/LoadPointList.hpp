// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/loads/LoadPoints.hpp"

namespace tokay::mapper {

/// Collects load points, each of one face.
class LoadPointList {
  public:
    void add(const Point& point, int face, double share) {
        const int row = static_cast<int>(points_.size());
        points_.push_back(point);
        shares_.emplace_back(row, face, share);
    }

    LoadPoints finish(int nFaces) const {
        const auto n = static_cast<Eigen::Index>(points_.size());
        LoadPoints loads{Points(n, 3), RowSparseMatrix(n, nFaces)};
        for (Eigen::Index i = 0; i < n; ++i) {
            loads.points.row(i) = points_[i];
        }
        loads.shares.setFromTriplets(shares_.begin(), shares_.end());
        return loads;
    }

  private:
    std::vector<Point> points_;
    std::vector<Eigen::Triplet<double>> shares_;
};

} // namespace tokay::mapper
