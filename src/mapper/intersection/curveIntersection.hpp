// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/interface/CurveInterface.hpp"
#include "mapper/intersection/MortarAssembler.hpp"

#include <functional>

namespace tokay::mapper {

/// A Gauss point on the destination, and its partner on the source.
struct CommonPoint {
    Point position;
    double weight; ///< length that the point stands for [m]
    Functions to;
    Location from;
};

/// Where the two sides of an interface of curves are integrated together.
struct CommonIntervals {
    GapLimit gapLimit;
    /// Gauss points an interval beyond those that integrate straight elements exactly.
    int nExtraPoints = 2;
};

/// Visits the Gauss points of the destination in intervals on which both sides are smooth:
/// the source's element ends are projected onto the destination's curves, and each Gauss
/// point back onto the source.
/// @param visit       each point
/// @param endElement  after the last point of each element of the destination
void visitCommonPoints(const CurveInterface& from, const CurveInterface& to,
                       const CommonIntervals& intervals,
                       const std::function<void(const CommonPoint&)>& visit,
                       const std::function<void()>& endElement);

/// Integrates over the destination by these points.
void integrateIntersection(const CurveInterface& from, const CurveInterface& to,
                           const GapLimit& gapLimit, int nExtraPoints, MortarAssembler& assembler,
                           GapStatistics& gaps);

} // namespace tokay::mapper
