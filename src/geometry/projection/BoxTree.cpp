// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/BoxTree.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <queue>

namespace tokay::geometry {

namespace {
constexpr int leafSize = 4;
}

Box Box::empty() {
    const double infinity = std::numeric_limits<double>::infinity();
    return {Point::Constant(infinity), Point::Constant(-infinity)};
}

Box Box::around(const Points& points) {
    return {points.colwise().minCoeff(), points.colwise().maxCoeff()};
}

BoxTree::BoxTree(std::vector<Box> boxes) : items_(boxes.size()), boxes_(std::move(boxes)) {
    assert(!boxes_.empty());
    std::iota(items_.begin(), items_.end(), 0);
    nodes_.push_back({Box::empty(), 0, static_cast<int>(items_.size()), -1});
    // Grows while it is walked: a node's children come after it.
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
        split(static_cast<int>(node));
    }
}

void BoxTree::split(int node) {
    const int begin = nodes_[node].begin, end = nodes_[node].end;
    Box centres = Box::empty();
    for (int i = begin; i < end; ++i) {
        nodes_[node].box.include(boxes_[items_[i]]);
        centres.include(boxes_[items_[i]].centre());
    }
    if (end - begin <= leafSize) {
        return;
    }
    int axis;
    (centres.upper - centres.lower).maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](int a, int b) {
                         return boxes_[a].lower[axis] + boxes_[a].upper[axis] <
                                boxes_[b].lower[axis] + boxes_[b].upper[axis];
                     });
    nodes_[node].left = static_cast<int>(nodes_.size());
    nodes_.push_back({Box::empty(), begin, middle, -1});
    nodes_.push_back({Box::empty(), middle, end, -1});
}

void BoxTree::visitNearest(const Point& point, const std::function<double(int)>& visit) const {
    // Items stand in the queue as -1 - item, so that they come out in order too.
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    double limit = std::numeric_limits<double>::infinity();
    queue.emplace(nodes_[0].box.squaredDistance(point), 0);
    while (!queue.empty() && queue.top().first <= limit) {
        const int entry = queue.top().second;
        queue.pop();
        if (entry < 0) {
            limit = visit(-1 - entry);
            continue;
        }
        const Node& node = nodes_[entry];
        if (node.left >= 0) {
            for (const int child : {node.left, node.left + 1}) {
                queue.emplace(nodes_[child].box.squaredDistance(point), child);
            }
            continue;
        }
        for (int i = node.begin; i < node.end; ++i) {
            queue.emplace(boxes_[items_[i]].squaredDistance(point), -1 - items_[i]);
        }
    }
}

std::vector<int> BoxTree::overlapping(const Box& box) const {
    return meeting([&](const Box& other) { return other.overlaps(box); });
}

} // namespace tokay::geometry
