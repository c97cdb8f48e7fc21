// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/ClosestCandidate.hpp"

namespace tokay::geometry {

double ClosestCandidate::slack() const {
    return 1e-6 * best_.norm() + 1e-12 * size_;
}

double ClosestCandidate::squaredLimit() const {
    const double limit = best_.norm() + slack();
    return limit * limit;
}

bool ClosestCandidate::offer(const Point& offset) {
    const double distance = offset.norm();
    if (!found_ || distance < best_.norm() - slack()) {
        best_ = offset;
        found_ = true;
        ambiguous_ = false;
        return true;
    }
    if (distance > best_.norm() + slack()) {
        return false;
    }
    // Next to a joint both pieces find almost the same place: that is not a
    // second one. On a plane, slack() alone lets places differ by 1.4e-3 distances.
    if ((offset - best_).norm() > 1e-2 * distance + 1e-6 * size_) {
        ambiguous_ = true;
    }
    const bool isBetter = distance < best_.norm();
    if (isBetter) {
        best_ = offset;
    }
    return isBetter;
}

} // namespace tokay::geometry
