// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

namespace tokay::geometry {

/// Keeps the best of the local minima that a projection meets, and notes
/// whether another place is as near.
class ClosestCandidate {
  public:
    explicit ClosestCandidate(double size) : size_(size) {}

    /// @param offset  from the point to the candidate
    /// @return true if it is the best so far
    bool offer(const Point& offset);

    bool isAmbiguous() const { return ambiguous_; }
    double distance() const { return best_.norm(); }

    /// Square of the distance beyond which a candidate changes nothing.
    double squaredLimit() const;

  private:
    double slack() const;

    double size_;
    Point best_;
    bool found_ = false;
    bool ambiguous_ = false;
};

} // namespace tokay::geometry
