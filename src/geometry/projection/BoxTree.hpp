// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <functional>
#include <vector>

namespace tokay::geometry {

/// Box parallel to the axes.
struct Box {
    Point lower, upper;

    static Box empty();
    static Box around(const Points& points);

    void include(const Point& point);
    void include(const Box& box);
    bool overlaps(const Box& other) const;
    /// Square of the distance of the point to the box; 0 inside.
    double squaredDistance(const Point& point) const;
    double diagonal() const { return (upper - lower).norm(); }
    Point centre() const { return 0.5 * (lower + upper); }
};

/// Tree over boxes, numbered as given, for the two questions of a mapper: which
/// ones are near a point, which ones overlap a box.
class BoxTree {
  public:
    explicit BoxTree(const std::vector<Box>& boxes);

    /// Visits boxes from near to far; the visitor returns the square of the
    /// distance beyond which no further box is wanted.
    void visitNearest(const Point& point, const std::function<double(int)>& visit) const;

    /// Numbers of the boxes that overlap, ascending.
    std::vector<int> overlapping(const Box& box) const;

    /// Numbers of the boxes that meet a region, ascending.
    /// @param meets  whether a box does; then so must every box that contains it
    std::vector<int> meeting(const std::function<bool(const Box&)>& meets) const;

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

} // namespace tokay::geometry
