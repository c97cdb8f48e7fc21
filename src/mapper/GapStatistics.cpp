// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/GapStatistics.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

namespace tokay::mapper {

bool GapStatistics::count(const Point& point, double gap, bool converged, bool ambiguous,
                          double measure) {
    const bool isMatched = converged && gap <= limit_.relative * size_;
    nUnmatched_ += !isMatched;
    nAmbiguous_ += ambiguous;
    measure_ += measure;
    matchedMeasure_ += isMatched ? measure : 0;
    if (worst_ < 0 || gap > largest_) {
        largest_ = gap;
        worst_ = nPoints_;
        worstPoint_ = point;
    }
    ++nPoints_;
    return isMatched;
}

void GapStatistics::enter(MappingReport& report) const {
    report.nPoints = nPoints_;
    report.nUnmatched = nUnmatched_;
    report.nAmbiguous = nAmbiguous_;
    report.coverage = measure_ > 0 ? matchedMeasure_ / measure_ : 0;
    report.largestGap = largest_;
    report.relativeGap = largest_ / size_;
    report.worstPoint = worst_;
    if (!limit_.refuse || report.relativeGap <= limit_.relative) {
        return;
    }
    throw InputError(fmt::format("the two sides of the interface do not lie on each other: "
                                 "point {} at ({:.6g}, {:.6g}, {:.6g}) is {:.4g} m away, "
                                 "{:.3g} of the interface size; the limit is {:.3g} ({} of {} "
                                 "points are beyond it); check position and units of both "
                                 "sides, or raise the limit",
                                 worst_, worstPoint_[0], worstPoint_[1], worstPoint_[2], largest_,
                                 report.relativeGap, limit_.relative, nUnmatched_, nPoints_));
}

void checkPoints(const Points& points) {
    if (points.rows() == 0) {
        throw InputError("there is no point to map to: the other side's interface is "
                         "empty");
    }
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        constexpr double most = 1e50; // squares and products of more overflow
        if (!(points.row(i).array().abs() <= most).all()) {
            throw InputError(fmt::format("interface point {} is ({}, {}, {}): coordinates must be "
                                         "finite and at most {:g}",
                                         i, points(i, 0), points(i, 1), points(i, 2), most));
        }
    }
}

} // namespace tokay::mapper
