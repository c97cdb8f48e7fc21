// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/BoxTree.hpp"
#include "mapper/Discretisation.hpp"

namespace tokay::mapper {

/// Points with a value each and nothing between them: mapping from it is the
/// nearest neighbour's value.
class PointCloud : public Discretisation {
  public:
    /// @throws InputError if there is no point, or one is not finite
    explicit PointCloud(Points points);

    std::string mappingName() const override { return "nearest neighbour"; }
    int nValues() const override { return static_cast<int>(points_.rows()); }
    const Points& coordinates() const override { return points_; }
    double size() const override { return size_; }
    Location locate(const Point& point) const override;

  private:
    Points points_;
    double size_;
    geometry::BoxTree tree_;
};

} // namespace tokay::mapper
