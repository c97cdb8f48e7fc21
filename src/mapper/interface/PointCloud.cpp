// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/PointCloud.hpp"

#include "geometry/projection/ClosestCandidate.hpp"
#include "mapper/GapStatistics.hpp"

namespace tokay::mapper {

namespace {

std::vector<geometry::Box> boxesOf(const Points& points) {
    checkPoints(points);
    std::vector<geometry::Box> boxes;
    boxes.reserve(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        boxes.push_back({points.row(i), points.row(i)});
    }
    return boxes;
}

} // namespace

PointCloud::PointCloud(Points points) : points_(std::move(points)), tree_(boxesOf(points_)) {
    size_ = geometry::Box::around(points_).diagonal();
}

Location PointCloud::locate(const Point& point) const {
    geometry::ClosestCandidate candidate(size_);
    int nearest = 0;
    tree_.visitNearest(point, [&](int i) {
        if (candidate.offer(points_.row(i).transpose() - point)) {
            nearest = i;
        }
        return candidate.squaredLimit();
    });
    return {
        {{nearest}, Eigen::VectorXd::Ones(1)}, candidate.distance(), true, candidate.isAmbiguous()};
}

} // namespace tokay::mapper
