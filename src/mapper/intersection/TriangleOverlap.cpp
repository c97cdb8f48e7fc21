// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/TriangleOverlap.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::mapper {

using geometry::Barycentric;
using geometry::Triangle;

TriangleOverlap::TriangleOverlap(const Triangle& below, const Triangle& above) {
    for (int i = 0; i < 3; ++i) {
        corners_[i] = below.barycentric(above.corner(i));
    }
    for (int side = 0; side < 3 && nCorners_ > 0; ++side) {
        clip(side);
    }
    for (int i = 1; i + 1 < nCorners_; ++i) {
        share_ += signedShare(i);
    }
    isTurned_ = share_ < 0;
    share_ = std::abs(share_);
}

/// Cuts off what lies beyond a side, where its coordinate is negative.
/// Source: Sutherland & Hodgman, Commun. ACM 17, 1974
void TriangleOverlap::clip(int side) {
    double least = corners_[0][side];
    for (int i = 1; i < nCorners_; ++i) {
        least = std::min(least, corners_[i][side]);
    }
    if (least >= 0) {
        return;
    }
    const std::array<Barycentric, 9> whole = corners_;
    const int n = nCorners_;
    nCorners_ = 0;
    for (int i = 0; i < n; ++i) {
        const Barycentric &a = whole[i], &b = whole[i + 1 < n ? i + 1 : 0];
        if (a[side] >= 0) {
            corners_[nCorners_++] = a;
        }
        if ((a[side] < 0 && b[side] > 0) || (a[side] > 0 && b[side] < 0)) {
            corners_[nCorners_] = a + a[side] / (a[side] - b[side]) * (b - a);
            corners_[nCorners_++][side] = 0;
        }
    }
}

double TriangleOverlap::signedShare(int i) const {
    const Barycentric u = corners_[i] - corners_[0], v = corners_[i + 1] - corners_[0];
    return u[1] * v[2] - u[2] * v[1];
}

double TriangleOverlap::share(int i) const {
    return isTurned_ ? -signedShare(i) : signedShare(i);
}

/// Over a triangle, the mean of a product of linear functions is a twelfth of the sum of their
/// products at the corners and of the product of their sums.
Eigen::Matrix3d TriangleOverlap::moments() const {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (int i = 1; i + 1 < nCorners_; ++i) {
        Eigen::Matrix<double, 3, 4> terms;
        terms << corners_[0], corners_[i], corners_[i + 1],
            corners_[0] + corners_[i] + corners_[i + 1];
        moments += share(i) / 12 * terms * terms.transpose();
    }
    return moments;
}

Barycentric TriangleOverlap::middle() const {
    Barycentric sum = Barycentric::Zero();
    for (int i = 0; i < nCorners_; ++i) {
        sum += corners_[i];
    }
    return sum / nCorners_;
}

} // namespace tokay::mapper
