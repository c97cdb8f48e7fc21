// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/MappingReport.hpp"

namespace tokay::mapper {

struct GapLimit {
    /// Largest gap allowed, relative to the size of the interface.
    double relative = 0.01;
    /// False: points beyond the limit are counted as unmatched, and the mapping
    /// does what it says of them.
    bool refuse = true;
};

/// Counts how well points of the destination find the source.
class GapStatistics {
  public:
    /// @param size  of the interface, to which the limit is relative [m]
    GapStatistics(const GapLimit& limit, double size) : limit_(limit), size_(size) {}

    /// @param measure  what the point stands for: 1, or its quadrature weight
    /// @return whether the point is matched
    bool count(const Point& point, double gap, bool converged, bool ambiguous, double measure = 1);

    /// Counts a part of the destination that the source does not reach at all.
    void countUncovered(double measure) { measure_ += measure; }

    /// Enters counts, gaps and coverage in the report.
    /// @throws InputError if a gap is beyond the limit and this is to be refused
    void enter(MappingReport& report) const;

  private:
    GapLimit limit_;
    double size_;
    int nPoints_ = 0, nUnmatched_ = 0, nAmbiguous_ = 0, worst_ = -1;
    double measure_ = 0, matchedMeasure_ = 0, largest_ = 0;
    Point worstPoint_ = Point::Zero();
};

/// @throws InputError naming the first point that is not finite, or if there is none
void checkPoints(const Points& points);

} // namespace tokay::mapper
