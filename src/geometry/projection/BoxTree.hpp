// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <vector>

namespace tokay::geometry {

/// Box parallel to the axes.
struct Box {
    Point lower, upper;

    static Box empty();
    static Box around(const Points& points);

    void include(const Point& point) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    void include(const Box& box) {
        lower = lower.cwiseMin(box.lower);
        upper = upper.cwiseMax(box.upper);
    }
    bool overlaps(const Box& other) const {
        return (lower.array() <= other.upper.array()).all() &&
               (other.lower.array() <= upper.array()).all();
    }
    /// Square of the distance of the point to the box; 0 inside.
    double squaredDistance(const Point& point) const {
        return (lower - point).cwiseMax(point - upper).cwiseMax(0).squaredNorm();
    }
    double diagonal() const { return (upper - lower).norm(); }
    Point centre() const { return 0.5 * (lower + upper); }
};

/// Tree over boxes, numbered as given, for the two questions of a mapper: which
/// ones are near a point, which ones overlap a box.
class BoxTree {
  public:
    explicit BoxTree(std::vector<Box> boxes);

    const Box& box(int number) const { return boxes_[number]; }

    /// Visits boxes from near to far; the visitor returns the square of the
    /// distance beyond which no further box is wanted.
    void visitNearest(const Point& point, const std::function<double(int)>& visit) const;

    /// Numbers of the boxes that overlap, ascending.
    std::vector<int> overlapping(const Box& box) const;

    /// Numbers of the boxes that meet a region, ascending.
    /// @param meets  whether a box does; then so must every box that contains it
    template <class Meets>
    std::vector<int> meeting(const Meets& meets) const;

  private:
    struct Node {
        Box box;
        /// Leaf: items_[begin, end). Inner node: its children are `left` and left + 1.
        int begin, end, left;
    };
    void split(int node);

    std::vector<Node> nodes_;
    std::vector<int> items_;
    std::vector<Box> boxes_;
};

template <class Meets>
std::vector<int> BoxTree::meeting(const Meets& meets) const {
    std::vector<int> found;
    // Halves of halves: 31 levels hold as many boxes as an int counts.
    std::array<int, 64> stack = {0};
    for (int nOnStack = 1; nOnStack > 0;) {
        const Node& node = nodes_[stack[--nOnStack]];
        if (!meets(node.box)) {
            continue;
        }
        if (node.left >= 0) {
            stack[nOnStack++] = node.left;
            stack[nOnStack++] = node.left + 1;
        } else {
            std::copy_if(items_.begin() + node.begin, items_.begin() + node.end,
                         std::back_inserter(found), [&](int item) { return meets(boxes_[item]); });
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace tokay::geometry
